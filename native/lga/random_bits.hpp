// Random bits of the lattice gas: a pure function of (seed, replica, step, site, draw), so that a
// replica has the same bits alone, among others, and in words of any width.
//
// Generator: ARS4x32-7 of Random123 (Salmon, Moraes, Dror and Shaw, SC'11,
// doi:10.1145/2063384.2063405): seven rounds of AES with a Weyl sequence as key schedule. Seven is
// the number of rounds they recommend; five pass all of BigCrush. One block is one draw of 128
// neighbouring replicas, one bit each.
#pragma once

#include <array>
#include <cstdint>

namespace crossgrain::lga {

/// Replicas that share a block.
inline constexpr int block_bits = 128;

/// First of the (up to 24) draws of each decision that is made at a site in one step.
enum class Draw : std::uint32_t {
    collision = 0,         ///< + 32 x stage
    right_kick = 2048,     ///< gravity, 2 -> 1
    left_kick = 2080,      ///< gravity, 4 -> 5
    vertical_kick = 2112,  ///< gravity, R -> 0 or 3 -> R: never both at one site
    reflection = 2144,     ///< at walls
    injection = 2176,      ///< + 32 x direction
    hop = 4096,            ///< + 3 x round of relocation
};

/// Two uses of one seed never share bits.
enum class RandomUse : std::uint64_t { dynamics = 0x6c6761, initial_state = 0x6c6762 };

/// Counter of one block: four 32-bit words as two 64-bit ones, the first being the lower.
struct Counter {
    std::uint64_t low = 0;   ///< step (lower half), site
    std::uint64_t high = 0;  ///< draw, block | step (upper half) << 8
};

/// Draw 0 of a site; the draw is added to `high`.
[[nodiscard]] constexpr Counter counter(std::int64_t step, std::uint32_t site,
                                        std::uint32_t block) noexcept {
    const auto t = static_cast<std::uint64_t>(step);
    return {.low = (t & 0xffffffffU) | std::uint64_t{site} << 32,
            .high = (std::uint64_t{block} | (t >> 32) << 8) << 32};
}

/// Keys of the rounds: key 0 is added to the counter, keys 1 to 7 belong to the rounds.
class RoundKeys {
  public:
    static constexpr int rounds = 7;
    RoundKeys(std::uint64_t seed, RandomUse use) noexcept;
    [[nodiscard]] const std::array<std::uint64_t, 2>& operator[](std::size_t i) const noexcept {
        return keys_[i];
    }

  private:
    std::array<std::array<std::uint64_t, 2>, rounds + 1> keys_;
};

/// The 128 bits of four successive draws from `first` on.
using Blocks = std::array<std::array<std::uint64_t, 2>, 4>;
[[nodiscard]] Blocks random_blocks(const RoundKeys& keys, Counter first);

}  // namespace crossgrain::lga
