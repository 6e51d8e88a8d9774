// Numbers as dumps write them, and what is wrong with a word that is none.
#pragma once

#include <optional>
#include <string_view>

namespace crossgrain::adapters::dump {

/// An integer (std::int64_t) or a double, whose sign may be + too. A double too small for the
/// format (1e-400) is the nearest there is, 0 or denormal; one too large is no number. "nan" and
/// "inf" are doubles. Nothing if the word is none, as a whole.
template <class Number>
[[nodiscard]] std::optional<Number> dump_number(std::string_view word);

/// "is not a number", and why, if that can be told: a decimal comma, Fortran's D, cut off.
[[nodiscard]] const char* why_no_number(std::string_view word);
[[nodiscard]] const char* why_no_integer(std::string_view word);

}  // namespace crossgrain::adapters::dump
