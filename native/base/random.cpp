#include "native/base/random.hpp"

#include <Random123/philox.h>

#include <cmath>
#include <numbers>

namespace crossgrain {
namespace {

std::array<double, 2> uniform_pair(std::uint64_t seed, RandomStream stream, std::uint64_t n) {
    r123::Philox4x32 philox;
    const r123::Philox4x32::ctr_type counter{{static_cast<std::uint32_t>(n),
                                              static_cast<std::uint32_t>(n >> 32),
                                              static_cast<std::uint32_t>(stream), 0U}};
    const r123::Philox4x32::key_type key{
        {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}};
    const auto bits = philox(counter, key);
    const auto open_unit = [](std::uint32_t high, std::uint32_t low) {
        const std::uint64_t word = (std::uint64_t{high} << 32) | low;
        // The odd multiple of 2^-54 keeps both end points out, so that log() is finite.
        return (static_cast<double>(word >> 11) + 0.5) * 0x1.0p-53;
    };
    return {open_unit(bits[0], bits[1]), open_unit(bits[2], bits[3])};
}

}  // namespace

double uniform(std::uint64_t seed, RandomStream stream, std::uint64_t n) {
    return uniform_pair(seed, stream, n)[0];
}

std::array<double, 2> normal_pair(std::uint64_t seed, RandomStream stream, std::uint64_t n) {
    const auto [u1, u2] = uniform_pair(seed, stream, n);
    const double radius = std::sqrt(-2.0 * std::log(u1));
    const double angle = 2.0 * std::numbers::pi * u2;
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace crossgrain
