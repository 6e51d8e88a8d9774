#include "cases/catalog/sweep_file.hpp"

#include "cases/catalog/case.hpp"
#include "cases/scene/choices.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace crossgrain::catalog {
namespace {

struct Axis {
    std::string key;
    toml::array values;
    bool texts = false;
    toml::source_position place;
};

CaseError sweep_error(const std::string& file, const Axis& axis, std::string problem,
                      std::string expected) {
    return CaseError({.file = file,
                      .line = static_cast<int>(axis.place.line),
                      .column = static_cast<int>(axis.place.column),
                      .key = "sweep." + axis.key,
                      .problem = std::move(problem),
                      .expected = std::move(expected)});
}

std::string text_of(const toml::node& value) {
    if (const auto text = value.value_exact<std::string>()) return *text;
    return fmt::format("{:g}", *value.value<double>());
}

void check_values(const std::string& file, const Axis& axis) {
    std::set<std::string> seen;
    for (const toml::node& value : axis.values) {
        const bool fits = axis.texts ? value.is_string() : value.is_number();
        if (!fits) {
            throw sweep_error(file, axis, "mixes texts and numbers, or has something else",
                              "an array of texts or an array of numbers");
        }
        // Values become parts of names.
        const std::string text = text_of(value);
        if (const auto fault = toml_input::fault_in(text, toml_input::TextKind::name)) {
            throw sweep_error(file, axis, "has a value that " + fault->problem + ": " + fault->got,
                              fault->expected);
        }
        if (!seen.insert(text).second) {
            throw sweep_error(file, axis, fmt::format("lists {} twice", text),
                              "each value once (they are told apart to six digits)");
        }
    }
}

/// ["*"]: all words that the key may have.
bool is_wildcard(const toml::array& values) {
    return values.size() == 1 && values.front().value_exact<std::string>() == "*";
}

Axis read_axis(const std::string& file, std::string_view key, const toml::node& node) {
    Axis axis{.key = std::string(key), .place = node.source().begin};
    const toml::array* values = node.as_array();
    if (values == nullptr || values->empty()) {
        throw sweep_error(file, axis, "is not a list of values", "an array with at least one");
    }
    axis.values = *values;
    if (const auto all = scene::words_of(axis.key); is_wildcard(*values) && !all.empty()) {
        axis.values = toml::array();
        for (const std::string& word : all)
            axis.values.push_back(word);
    }
    axis.texts = axis.values.front().is_string();
    if (axis.values.size() > most_runs) {
        throw sweep_error(file, axis, fmt::format("lists {} values", axis.values.size()),
                          fmt::format("at most {} runs in a case", most_runs));
    }
    check_values(file, axis);
    return axis;
}

void add_axes(const toml::table& table, const std::string& prefix, const std::string& file,
              std::vector<Axis>& axes) {
    for (const auto& [key, node] : table) {
        const std::string name = prefix + std::string(key.str());
        if (const auto* deeper = node.as_table()) {
            add_axes(*deeper, name + ".", file, axes);
        } else {
            axes.push_back(read_axis(file, name, node));
        }
    }
}

/// The tables that a key lies in: "a" and "a.b" of "a.b.c".
std::vector<std::string> owners_of(const std::string& key) {
    std::vector<std::string> owners;
    for (auto dot = key.find('.'); dot != std::string::npos; dot = key.find('.', dot + 1))
        owners.push_back(key.substr(0, dot));
    return owners;
}

/// Each axis must lead to a place of its own in the scene.
void check_keys(const std::string& file, const std::vector<Axis>& axes) {
    constexpr std::size_t most_axes = 32;
    std::set<std::string> keys;
    for (const Axis& axis : axes) {
        const auto fault = toml_input::fault_in(axis.key, toml_input::TextKind::name);
        const bool part_is_empty = axis.key.starts_with('.') || axis.key.ends_with('.') ||
                                   axis.key.find("..") != std::string::npos;
        if (fault || part_is_empty) {
            throw sweep_error(file, axis,
                              fault ? "has a key that " + fault->problem : "has an empty key",
                              "keys of [scene], as \"dt\" or \"contact.restitution\"");
        }
        if (!keys.insert(axis.key).second) {
            throw sweep_error(file, axis, "is swept twice", "each key once");
        }
    }
    for (const Axis& axis : axes) {
        for (const std::string& owner : owners_of(axis.key)) {
            if (!keys.contains(owner)) continue;
            throw sweep_error(file, axis,
                              fmt::format("lies in '{}', which is swept as well", owner),
                              "one of the two");
        }
    }
    if (axes.size() > most_axes) {
        throw sweep_error(file, axes.back(), fmt::format("is one of {} keys", axes.size()),
                          fmt::format("at most {}", most_axes));
    }
}

std::vector<Axis> read_axes(const toml::table& table, const std::string& file) {
    std::vector<Axis> axes;
    add_axes(table, "", file, axes);
    check_keys(file, axes);
    std::sort(axes.begin(), axes.end(), [](const Axis& a, const Axis& b) {
        if (a.texts != b.texts) return a.texts;
        return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
    });
    return axes;
}

void lay_over(std::vector<Axis>& axes, const toml::table& quick, const std::string& file) {
    for (Axis& upper : read_axes(quick, file)) {
        const auto lower = std::find_if(axes.begin(), axes.end(),
                                        [&](const Axis& a) { return a.key == upper.key; });
        if (lower == axes.end()) {
            throw sweep_error(file, upper, "is not a key of the case's own [sweep]",
                              "one of its keys, with other values");
        }
        lower->values = upper.values;
    }
}

/// "restitution" of "contact.restitution".
std::string short_name(const Axis& axis) {
    return axis.key.substr(axis.key.rfind('.') + 1);
}

SweepPoint extended(const SweepPoint& point, const Axis& axis, const toml::node& value) {
    SweepPoint next = point;
    const std::string text = text_of(value);
    next.name += next.name.empty() ? "" : "/";
    next.name += axis.texts ? text : fmt::format("{}={}", short_name(axis), text);
    next.parameters.emplace_back(short_name(axis), text);
    toml::table* place = &next.scene;
    std::string_view key = axis.key;
    for (auto dot = key.find('.'); dot != std::string_view::npos; dot = key.find('.')) {
        place = place->insert(key.substr(0, dot), toml::table{}).first->second.as_table();
        key.remove_prefix(dot + 1);
    }
    value.visit([&](const auto& node) { place->insert_or_assign(key, node); });
    return next;
}

/// Before any combination is made.
void check_size(const std::string& file, const std::vector<Axis>& axes) {
    double points = 1;
    for (const Axis& axis : axes)
        points *= static_cast<double>(axis.values.size());
    if (points <= static_cast<double>(most_runs)) return;
    throw CaseError({.file = file,
                     .line = static_cast<int>(axes.front().place.line),
                     .key = "sweep",
                     .problem = "makes too many combinations",
                     .got = fmt::format("{:.6g}", points),
                     .expected = fmt::format("at most {} runs in a case", most_runs)});
}

/// Numbers along other keys stay at their first value.
void keep_only(const std::vector<std::string>& keys, const std::string& file,
               std::vector<Axis>& axes) {
    for (const std::string& key : keys) {
        std::vector<std::string> names;
        for (const Axis& axis : axes)
            if (!axis.texts) names.push_back(short_name(axis));
        if (std::ranges::find(names, key) != names.end()) continue;
        throw CaseError({.file = file,
                         .key = "--map",
                         .problem = "names no axis of this case's map",
                         .got = fmt::format("'{}'", key),
                         .expected = fmt::format("two of {}", fmt::join(names, ", "))});
    }
    for (Axis& axis : axes) {
        if (axis.texts || std::ranges::find(keys, short_name(axis)) != keys.end()) continue;
        axis.values.erase(axis.values.begin() + 1, axis.values.end());
    }
}

}  // namespace

Sweep read_sweep(const toml::table* base, const toml::table* quick, const std::string& file,
                 const std::vector<std::string>& only) {
    Sweep sweep{.points = {SweepPoint{}}, .lines = {}};
    std::vector<Axis> axes;
    if (base != nullptr) axes = read_axes(*base, file);
    if (quick != nullptr) lay_over(axes, *quick, file);
    if (!only.empty()) keep_only(only, file, axes);
    check_size(file, axes);
    for (const Axis& axis : axes) {
        sweep.lines[axis.key] = static_cast<int>(axis.place.line);
        std::vector<SweepPoint> next;
        for (const SweepPoint& point : sweep.points) {
            for (const toml::node& value : axis.values)
                next.push_back(extended(point, axis, value));
        }
        sweep.points = std::move(next);
    }
    return sweep;
}

}  // namespace crossgrain::catalog
