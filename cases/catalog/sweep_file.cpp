#include "cases/catalog/sweep_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace crossgrain::catalog {
namespace {

struct Axis {
    std::string key;  ///< of [scene], with dots for one of its tables: "initial.angle"
    const toml::array* values = nullptr;
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
    std::vector<std::string> seen;
    for (const toml::node& value : *axis.values) {
        const bool fits = axis.texts ? value.is_string() : value.is_number();
        if (!fits) {
            throw sweep_error(file, axis, "mixes texts and numbers, or has something else",
                              "an array of texts or an array of numbers");
        }
        const std::string text = text_of(value);
        if (std::find(seen.begin(), seen.end(), text) != seen.end()) {
            throw sweep_error(file, axis, fmt::format("lists {} twice", text),
                              "each value once (they are told apart to six digits)");
        }
        seen.push_back(text);
    }
}

Axis read_axis(const std::string& file, std::string_view key, const toml::node& node) {
    Axis axis{.key = std::string(key), .place = node.source().begin};
    axis.values = node.as_array();
    if (axis.values == nullptr || axis.values->empty()) {
        throw sweep_error(file, axis, "is not a list of values", "an array with at least one");
    }
    axis.texts = axis.values->front().is_string();
    check_values(file, axis);
    return axis;
}

std::vector<Axis> read_axes(const toml::table& table, const std::string& file) {
    std::vector<Axis> axes;
    for (const auto& [key, node] : table)
        axes.push_back(read_axis(file, key.str(), node));
    std::sort(axes.begin(), axes.end(), [](const Axis& a, const Axis& b) {
        if (a.texts != b.texts) return a.texts;
        return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
    });
    return axes;
}

void lay_over(std::vector<Axis>& axes, const toml::table& quick, const std::string& file) {
    for (const auto& [key, node] : quick) {
        Axis upper = read_axis(file, key.str(), node);
        const auto lower = std::find_if(axes.begin(), axes.end(),
                                        [&](const Axis& a) { return a.key == upper.key; });
        if (lower == axes.end()) {
            throw sweep_error(file, upper, "is not a key of the case's own [sweep]",
                              "one of its keys, with other values");
        }
        lower->values = upper.values;
    }
}

/// "angle" of "initial.angle".
std::string short_name(const std::string& key) {
    return key.substr(key.rfind('.') + 1);
}

/// Sets table.a.b = value for the key "a.b".
void set_nested(toml::table& table, const std::string& key, const toml::node& value) {
    const auto dot = key.find('.');
    if (dot == std::string::npos) {
        value.visit([&](const auto& node) { table.insert_or_assign(key, node); });
        return;
    }
    auto& inner = *table.insert(key.substr(0, dot), toml::table{}).first->second.as_table();
    set_nested(inner, key.substr(dot + 1), value);
}

SweepPoint extended(const SweepPoint& point, const Axis& axis, const toml::node& value) {
    SweepPoint next = point;
    const std::string text = text_of(value);
    next.name += next.name.empty() ? "" : "/";
    const std::string name = short_name(axis.key);
    next.name += axis.texts ? text : fmt::format("{}={}", name, text);
    next.parameters.emplace_back(name, text);
    set_nested(next.scene, axis.key, value);
    return next;
}

}  // namespace

Sweep read_sweep(const toml::table* base, const toml::table* quick, const std::string& file) {
    Sweep sweep{.points = {SweepPoint{}}, .lines = {}};
    std::vector<Axis> axes;
    if (base != nullptr) axes = read_axes(*base, file);
    if (quick != nullptr) lay_over(axes, *quick, file);
    for (const Axis& axis : axes) {
        sweep.lines[axis.key] = static_cast<int>(axis.place.line);
        std::vector<SweepPoint> next;
        for (const SweepPoint& point : sweep.points) {
            for (const toml::node& value : *axis.values)
                next.push_back(extended(point, axis, value));
        }
        sweep.points = std::move(next);
    }
    return sweep;
}

}  // namespace crossgrain::catalog
