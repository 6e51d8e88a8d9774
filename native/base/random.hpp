// Counter-based random numbers: the n-th number of a stream is a pure function of (seed, stream,
// n), so results do not depend on the order or on the threads in which they are drawn. Generator:
// Philox4x32-10 (Salmon et al., SC'11, doi:10.1145/2063384.2063405) from Random123.
#pragma once

#include <array>
#include <cstdint>

namespace crossgrain {

/// Names a stream, so that two uses of one seed never share numbers.
enum class RandomStream : std::uint32_t {
    initial_velocity = 1,
    initial_position = 2,
    jitter = 3,
    initial_size = 4,
    initial_spin = 5,
    signal = 20
};

/// Uniform in the open interval (0, 1), 53 bits, for counter `n` of the stream.
[[nodiscard]] double uniform(std::uint64_t seed, RandomStream stream, std::uint64_t n);

/// Two independent standard normal deviates for counter `n` (Box & Muller 1958).
[[nodiscard]] std::array<double, 2> normal_pair(std::uint64_t seed, RandomStream stream,
                                                std::uint64_t n);

}  // namespace crossgrain
