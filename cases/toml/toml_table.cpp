#include "cases/toml/toml_table.hpp"

#include "cases/toml/nesting.hpp"
#include "cases/toml/text_file.hpp"
#include "native/base/printable.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <sstream>

namespace crossgrain::toml_input {
namespace {

std::string shown(const toml::node& node) {
    if (node.is_table()) return "a table";
    if (node.is_array()) return "an array";
    std::ostringstream out;
    node.visit([&](const auto& value) { out << value; });
    return printable(out.str());
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t above = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] != b[j - 1])});
            diagonal = above;
        }
    }
    return row[b.size()];
}

}  // namespace

std::optional<std::string> nearest(std::string_view word, std::span<const std::string> candidates) {
    std::optional<std::string> best;
    std::size_t best_distance = std::max<std::size_t>(2, word.size() / 3) + 1;
    for (const auto& candidate : candidates) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance < best_distance) {
            best = candidate;
            best_distance = distance;
        }
    }
    return best;
}

toml::table parse_toml_file(const std::string& file, std::stop_token stop) {
    return parse_toml(read_text_file(file, "a TOML file", std::move(stop)), file);
}

toml::table parse_toml(std::string_view text, const std::string& file) {
    check_nesting(text, file);
    try {
        return toml::parse(text, file);
    } catch (const toml::parse_error& error) {
        throw CaseError(
            {.file = file,
             .line = static_cast<int>(error.source().begin.line),
             .column = static_cast<int>(error.source().begin.column),
             .problem = fmt::format("is not valid TOML: {}", printable(error.description()))});
    }
}

TomlTable::TomlTable(std::string file, std::string path, std::vector<const toml::table*> layers)
    : file_(std::move(file)), path_(std::move(path)), layers_(std::move(layers)) {}

std::string TomlTable::dotted(std::string_view key) const {
    if (key.empty()) return path_;
    return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

int TomlTable::line() const {
    return layers_.empty() ? 0 : static_cast<int>(layers_.back()->source().begin.line);
}

const toml::node* TomlTable::find(std::string_view key) const {
    if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.emplace_back(key);
    for (const auto* layer : layers_) {
        if (const auto* node = layer->get(key)) return node;
    }
    return nullptr;
}

bool TomlTable::has(std::string_view key) const {
    return find(key) != nullptr;
}

const toml::node& TomlTable::required(std::string_view key, std::string_view type) const {
    const auto* node = find(key);
    if (node == nullptr) throw missing(key, std::string(type));
    return *node;
}

CaseError TomlTable::missing(std::string_view key, std::string expected) const {
    const std::vector<std::string> wanted{std::string(key)};
    for (const auto* layer : layers_) {
        for (const auto& [present, node] : *layer) {
            const bool known =
                std::find(asked_.begin(), asked_.end(), present.str()) != asked_.end();
            // Short keys (x, vx) resemble each other without being misspelt.
            constexpr std::size_t shortest = 4;
            if (known || present.str().size() < shortest || !nearest(present.str(), wanted)) {
                continue;
            }
            return error_at(present.source(), present.str(), "is not a known key", "", "",
                            fmt::format("did you mean '{}'?", key));
        }
    }
    return error(key, "is missing", "", std::move(expected));
}

double TomlTable::checked(std::string_view key, const toml::node& node, const Range& range) const {
    const auto value = node.value<double>();
    if (!node.is_number() || !value) {
        throw error_at(node.source(), key, "has the wrong type", shown(node), range.text, {});
    }
    if (!range.holds(*value)) {
        throw error_at(node.source(), key, "is out of range", shown(node), range.text, {});
    }
    return *value;
}

double TomlTable::number(std::string_view key, const Range& range) const {
    return checked(key, required(key, range.text), range);
}

std::optional<double> TomlTable::optional_number(std::string_view key, const Range& range) const {
    const auto* node = find(key);
    if (node == nullptr) return std::nullopt;
    return checked(key, *node, range);
}

std::vector<double> TomlTable::numbers(std::string_view key, const Range& range) const {
    const auto& node = required(key, range.text);
    const auto* array = node.as_array();
    if (array == nullptr) return {checked(key, node, range)};
    if (array->empty()) throw error(key, "is empty", "[]", "at least one number");
    std::vector<double> values;
    for (const auto& element : *array)
        values.push_back(checked(key, element, range));
    return values;
}

std::int64_t TomlTable::integer(std::string_view key, std::int64_t least, std::int64_t most) const {
    const bool bounded = most < std::numeric_limits<std::int64_t>::max();
    const std::string expected = bounded ? fmt::format("an integer from {} to {}", least, most)
                                         : fmt::format("an integer >= {}", least);
    const auto& node = required(key, expected);
    const auto value = node.value_exact<std::int64_t>();
    if (!value) throw error(key, "has the wrong type", shown(node), expected);
    if (*value < least || *value > most) {
        throw error(key, "is out of range", shown(node), expected);
    }
    return *value;
}

std::string TomlTable::checked(std::string_view key, const toml::node& node, TextKind kind) const {
    auto value = node.value_exact<std::string>();
    if (!value)
        throw error_at(node.source(), key, "has the wrong type", shown(node), "a string", {});
    if (auto fault = fault_in(*value, kind)) {
        throw error_at(node.source(), key, fault->problem, fault->got, fault->expected, {});
    }
    return *std::move(value);
}

std::string TomlTable::text(std::string_view key) const {
    return checked(key, required(key, "a string"), TextKind::line);
}

std::string TomlTable::name(std::string_view key) const {
    return checked(key, required(key, "a string"), TextKind::name);
}

std::string TomlTable::prose(std::string_view key) const {
    return checked(key, required(key, "a string"), TextKind::prose);
}

std::optional<std::string> TomlTable::optional_text(std::string_view key) const {
    if (!has(key)) return std::nullopt;
    return text(key);
}

std::vector<std::string> TomlTable::texts(std::string_view key) const {
    const auto& node = required(key, "an array of strings");
    const auto* array = node.as_array();
    if (array == nullptr)
        throw error(key, "has the wrong type", shown(node), "an array of strings");
    std::vector<std::string> values;
    for (const auto& element : *array)
        values.push_back(checked(key, element, TextKind::line));
    return values;
}

bool TomlTable::boolean(std::string_view key) const {
    const auto& node = required(key, "true or false");
    const auto value = node.value_exact<bool>();
    if (!value) throw error(key, "has the wrong type", shown(node), "true or false");
    return *value;
}

bool TomlTable::is_text(std::string_view key) const {
    const auto* node = find(key);
    return node != nullptr && node->is_string();
}

bool TomlTable::is_table(std::string_view key) const {
    const auto* node = find(key);
    return node != nullptr && node->is_table();
}

std::size_t TomlTable::choice(std::string_view key, std::span<const std::string> words) const {
    const std::string value = text(key);
    const auto found = std::find(words.begin(), words.end(), value);
    if (found == words.end()) {
        const auto near = nearest(value, words);
        throw error(key, "is not known", fmt::format("\"{}\"", value),
                    fmt::format("one of \"{}\"", fmt::join(words, "\", \"")),
                    near ? fmt::format("did you mean \"{}\"?", *near) : "");
    }
    return static_cast<std::size_t>(found - words.begin());
}

TomlTable TomlTable::table(std::string_view key) const {
    if (!has(key)) return {file_, dotted(key), {}};
    std::vector<const toml::table*> layers;
    for (const auto* layer : layers_) {
        const auto* node = layer->get(key);
        if (node == nullptr) continue;
        if (!node->is_table()) {
            throw error_at(node->source(), key, "has the wrong type", shown(*node), "a table", {});
        }
        layers.push_back(node->as_table());
    }
    return {file_, dotted(key), std::move(layers)};
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
    std::vector<TomlTable> result;
    const auto* node = find(key);
    if (node == nullptr) return result;
    const auto* array = node->as_array();
    if (array == nullptr || !array->is_array_of_tables()) {
        throw error(key, "has the wrong type", shown(*node), fmt::format("[[{}]] tables", key));
    }
    for (const auto& element : *array) {
        result.emplace_back(file_, dotted(key),
                            std::vector<const toml::table*>{element.as_table()});
    }
    return result;
}

std::vector<std::string> TomlTable::keys() const {
    constexpr std::size_t most_keys = 10'000;
    std::vector<std::string> result;
    std::set<std::string> seen;
    for (const auto* layer : layers_) {
        for (const auto& [key, node] : *layer) {
            const std::string name(key.str());
            if (const auto fault = fault_in(name, TextKind::name)) {
                throw error_at(key.source(), {}, "has a key that is no name: " + fault->problem,
                               fault->got, fault->expected, {});
            }
            if (seen.insert(name).second) result.push_back(name);
            if (result.size() > most_keys) {
                throw error_at(key.source(), {}, "has too many keys", "",
                               fmt::format("at most {}", most_keys), {});
            }
        }
    }
    return result;
}

void TomlTable::reject_unknown_keys() const {
    for (const auto* layer : layers_) {
        for (const auto& [key, node] : *layer) {
            if (std::find(asked_.begin(), asked_.end(), key.str()) != asked_.end()) continue;
            const auto near = nearest(key.str(), asked_);
            throw error_at(key.source(), key.str(), "is not a known key", "",
                           fmt::format("one of {}", fmt::join(asked_, ", ")),
                           near ? fmt::format("did you mean '{}'?", *near) : "");
        }
    }
}

CaseError TomlTable::error(std::string_view key, std::string problem, std::string got,
                           std::string expected, std::string hint) const {
    toml::source_region where{};
    if (const auto* node = find(key)) {
        where = node->source();
    } else if (!layers_.empty()) {
        where = layers_.back()->source();
    }
    return error_at(where, key, std::move(problem), std::move(got), std::move(expected),
                    std::move(hint));
}

CaseError TomlTable::error_at(const toml::source_region& where, std::string_view key,
                              std::string problem, std::string got, std::string expected,
                              std::string hint) const {
    return CaseError({.file = file_,
                      .line = static_cast<int>(where.begin.line),
                      .column = static_cast<int>(where.begin.column),
                      .key = dotted(key),
                      .problem = std::move(problem),
                      .got = std::move(got),
                      .expected = std::move(expected),
                      .hint = std::move(hint)});
}

}  // namespace crossgrain::toml_input
