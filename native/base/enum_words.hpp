// One table of words per enum, for files, outputs and their schema. Beside the enum stands
//
//   enum class Damping { full_vector, normal_only };
//   constexpr auto words(Damping) { return std::array{"full-vector", "normal-only"}; }
//
// in the order of its values, which count from 0. A value without a word does not compile.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace crossgrain {

template <class E>
concept HasWords = std::is_enum_v<E> && requires(E value) {
    words(value);
};

/// Whether a value has a name in its enum: g++ and clang write one that has none as "(E)7".
template <auto value>
consteval bool is_enumerator() {
    const std::string_view text = __PRETTY_FUNCTION__;
    const char first = text.at(text.find("value = ") + 8);
    return first != '(' && first != '-' && (first < '0' || first > '9');
}

template <HasWords E>
inline constexpr auto table_of_words = [] {
    constexpr auto table = words(E{});
    static_assert(is_enumerator<E(table.size() - 1)>(), "a word has no value");
    static_assert(!is_enumerator<E(table.size())>(), "a value has no word");
    return table;
}();

template <HasWords E>
[[nodiscard]] std::string to_string(E value) {
    return table_of_words<E>.at(static_cast<std::size_t>(value));
}

/// In the order of the values.
template <HasWords E>
[[nodiscard]] std::vector<std::string> all_words() {
    return {table_of_words<E>.begin(), table_of_words<E>.end()};
}

/// Nothing for a word that is not in the table.
template <HasWords E>
[[nodiscard]] std::optional<E> from_word(std::string_view word) {
    const auto& table = table_of_words<E>;
    const auto found = std::ranges::find(table, word);
    if (found == table.end()) return std::nullopt;
    return static_cast<E>(found - table.begin());
}

}  // namespace crossgrain
