#include "adapters/dump/dump_number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <system_error>
#include <type_traits>

namespace crossgrain::adapters::dump {
namespace {

/// std::from_chars knows no plus sign.
std::string_view without_plus(std::string_view word) {
    const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+';
    return plus ? word.substr(1) : word;
}

/// std::from_chars calls numbers beyond the format out of range at both ends and gives no value.
std::optional<double> underflow(std::string_view word) {
    const double value = std::strtod(std::string(word).c_str(), nullptr);
    if (std::abs(value) > 1) return std::nullopt;
    return value;
}

template <class Number>
bool is_number(std::string word) {
    return dump_number<Number>(word).has_value();
}

std::string replaced(std::string_view word, std::string_view from, char to) {
    std::string result(word);
    for (char& c : result)
        if (from.find(c) != std::string_view::npos) c = to;
    return result;
}

}  // namespace

template <class Number>
std::optional<Number> dump_number(std::string_view word) {
    word = without_plus(word);
    Number value{};
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (stop != end || word.empty()) return std::nullopt;
    if (error == std::errc{}) return value;
    if constexpr (std::is_floating_point_v<Number>) {
        if (error == std::errc::result_out_of_range) return underflow(word);
    }
    return std::nullopt;
}

template std::optional<double> dump_number<double>(std::string_view word);
template std::optional<std::int64_t> dump_number<std::int64_t>(std::string_view word);

const char* why_no_number(std::string_view word) {
    if (is_number<double>(replaced(word, ",", '.'))) {
        return "is not a number (a decimal comma; numbers have a point)";
    }
    if (is_number<double>(replaced(word, "Dd", 'e'))) {
        return "is not a number (Fortran's D; exponents have an e)";
    }
    if (is_number<double>(std::string(word) + "0")) {
        return "is not a number (it seems to be cut off)";
    }
    return "is not a number";
}

const char* why_no_integer(std::string_view word) {
    return is_number<double>(std::string(word)) ? "is not a whole number of at most 64 bits"
                                                : why_no_number(word);
}

}  // namespace crossgrain::adapters::dump
