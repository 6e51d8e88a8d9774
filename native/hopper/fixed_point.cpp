#include "native/hopper/fixed_point.hpp"

#include "native/base/errors.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <string_view>

namespace crossgrain::hopper {
namespace {

constexpr int decimals = 12;  // of the unit

[[noreturn]] void refuse(double value, const char* key, const char* problem) {
    throw CaseError({.key = key,
                     .problem = problem,
                     .got = fmt::format("{}", value),
                     .expected = "a decimal number from 0 to 1e5 with at most 12 digits after the "
                                 "point",
                     .hint = "round it"});
}

}  // namespace

Energy to_energy(double value, const char* key) {
    if (!(value >= 0 && value <= largest_coefficient)) refuse(value, key, "is out of range");
    // Shortest scientific form: d.ddd...e[+-]xx
    std::array<char, 64> text{};
    const auto written =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific);
    const std::string_view form(text.data(), static_cast<std::size_t>(written.ptr - text.data()));
    const auto mark = form.find('e');
    Energy digits = 0;
    int after_point = 0;
    for (const char c : form.substr(0, mark)) {
        if (c == '.') continue;
        digits = 10 * digits + (c - '0');
        ++after_point;
    }
    --after_point;  // the first digit stands before the point
    int exponent = 0;
    const char* exponent_start = form.data() + mark + (form[mark + 1] == '+' ? 2 : 1);
    std::from_chars(exponent_start, form.data() + form.size(), exponent);
    const int power = exponent - after_point + decimals;
    if (power < 0 && digits != 0) refuse(value, key, "has too many digits");
    for (int i = 0; i < power && digits != 0; ++i)
        digits *= 10;
    return digits;
}

}  // namespace crossgrain::hopper
