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

constexpr std::array<const char*, 7> meaning_names = {"", "id", "x", "y", "vx", "vy", "omegaz"};

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
    meanings_.assign(words.size(), Meaning::ignored);
    std::size_t needed = 0;
    const auto assign = [&](Meaning meaning, std::string_view name, std::string_view other = {}) {
        auto found = std::find(words.begin(), words.end(), name);
        if (found == words.end() && !other.empty()) {
            found = std::find(words.begin(), words.end(), other);
        }
        if (found == words.end()) {
            throw TrajectoryError(
                fmt::format("column '{}' is missing (found:{})", name, printable(names)));
        }
        const auto index = static_cast<std::size_t>(found - words.begin());
        meanings_[index] = meaning;
        needed = std::max(needed, index + 1);
    };
    assign(Meaning::id, "id");
    assign(Meaning::x, "xu", periodic_x ? "" : "x");
    assign(Meaning::y, "yu", periodic_y ? "" : "y");
    assign(Meaning::vx, "vx");
    assign(Meaning::vy, "vy");
    if (spins) assign(Meaning::omega, "omegaz");
    meanings_.resize(needed);
}

Row Columns::read(std::string_view line) const {
    Row row;
    std::string_view rest = line;
    for (const Meaning meaning : meanings_) {
        const std::string_view word = next_word(rest);
        if (word.empty()) {
            throw TrajectoryError(fmt::format("row '{}' has too few columns", printable(line)));
        }
        if (meaning == Meaning::ignored) continue;
        const auto index = static_cast<std::size_t>(meaning);
        if (meaning == Meaning::id) {
            row.id = parse<std::int64_t>(word, "id");
            continue;
        }
        const auto value = parse<double>(word, meaning_names[index]);
        if (!std::isfinite(value)) {
            throw TrajectoryError(fmt::format("'{}' in column {} is not finite",
                                              printable(word, longest_word), meaning_names[index]));
        }
        row.values[index - static_cast<std::size_t>(Meaning::x)] = value;
    }
    return row;
}

}  // namespace crossgrain::adapters::dump
