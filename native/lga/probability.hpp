// Probabilities as 24-bit binary fractions: a decision compares the bits of a uniform number, most
// significant first, with those of the probability, and ends as soon as they differ.
#pragma once

#include <bit>
#include <cstdint>

namespace crossgrain::lga {

inline constexpr int probability_bits = 24;
inline constexpr std::uint32_t certain = 1U << probability_bits;

/// `probability` in [0, 1] rounded to 2^-24: the error is at most 2^-25.
[[nodiscard]] constexpr std::uint32_t fixed_point(double probability) noexcept {
    return static_cast<std::uint32_t>(probability * certain + 0.5);
}

/// Bits of a uniform number that can decide `u < value`: none for 0 and 1, one for 1/2, ...
[[nodiscard]] constexpr int deciding_bits(std::uint32_t value) noexcept {
    if (value == 0 || value >= certain) return 0;
    return probability_bits - std::countr_zero(value);
}

}  // namespace crossgrain::lga
