#include "adapters/dump/dump_columns.hpp"

#include "adapters/dump/dump_number.hpp"
#include "native/base/errors.hpp"
#include "native/base/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace crossgrain::adapters::dump {

namespace {

constexpr std::array<const char*, column_count> names_of_columns = {
    "x", "y", "vx", "vy", "omegaz", "z", "vz", "radius", "mass"};

constexpr std::size_t longest_word = 60;

constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

/// The next word; moves `rest` behind it.
std::string_view next_word(std::string_view& rest) {
    const char* begin = rest.data();
    const char* const end = begin + rest.size();
    while (begin != end && is_blank(*begin))
        ++begin;
    const char* stop = begin;
    while (stop != end && !is_blank(*stop))
        ++stop;
    rest = {stop, static_cast<std::size_t>(end - stop)};
    return {begin, static_cast<std::size_t>(stop - begin)};
}

template <class Number>
Number parse(std::string_view word, const char* column) {
    if (const auto value = dump_number<Number>(word)) return *value;
    throw TrajectoryError(
        fmt::format("'{}' in column {} {}", printable(word, longest_word), column,
                    std::is_integral_v<Number> ? why_no_integer(word) : why_no_number(word)));
}

}  // namespace

Columns::Columns(std::string_view names, bool periodic_x, bool periodic_y, bool spins) {
    std::vector<std::string_view> words;
    for (auto rest = names; !rest.empty();)
        words.push_back(next_word(rest));
    meanings_.assign(words.size(), ignored);
    std::size_t needed = 0;
    const auto find = [&](std::string_view name, std::string_view other, std::uint8_t meaning) {
        auto found = std::find(words.begin(), words.end(), name);
        if (found == words.end() && !other.empty()) {
            found = std::find(words.begin(), words.end(), other);
        }
        if (found == words.end()) return false;
        const auto index = static_cast<std::size_t>(found - words.begin());
        meanings_[index] = meaning;
        needed = std::max(needed, index + 1);
        if (meaning < column_count) present_[meaning] = true;
        return true;
    };
    const auto require = [&](std::string_view name, std::string_view other, std::uint8_t meaning) {
        if (find(name, other, meaning)) return;
        throw TrajectoryError(
            fmt::format("column '{}' is missing (found:{})", name, printable(names)));
    };
    const auto number = [](Column column) { return static_cast<std::uint8_t>(column); };
    require("id", "", id);
    require("xu", periodic_x ? "" : "x", number(Column::x));
    require("yu", periodic_y ? "" : "y", number(Column::y));
    require("vx", "", number(Column::vx));
    require("vy", "", number(Column::vy));
    if (spins) require("omegaz", "", number(Column::omega));
    (void)find("zu", "z", number(Column::z));
    for (const Column column : {Column::vz, Column::radius, Column::mass})
        (void)find(names_of_columns[number(column)], "", number(column));
    meanings_.resize(needed);
}

Row Columns::read(std::string_view line) const {
    Row row;
    std::string_view rest = line;
    for (const std::uint8_t meaning : meanings_) {
        const std::string_view word = next_word(rest);
        if (word.empty()) {
            throw TrajectoryError(fmt::format("row '{}' has too few columns", printable(line)));
        }
        if (meaning == ignored) continue;
        if (meaning == id) {
            row.id = parse<std::int64_t>(word, "id");
            continue;
        }
        const auto value = parse<double>(word, names_of_columns[meaning]);
        if (!std::isfinite(value)) {
            throw TrajectoryError(fmt::format("'{}' in column {} is not finite",
                                              printable(word, longest_word),
                                              names_of_columns[meaning]));
        }
        row.values[meaning] = value;
    }
    return row;
}

}  // namespace crossgrain::adapters::dump
