// Random numbers of a run: pure functions of (seed, run, iteration, site) or of the position in a
// stream, so that results depend neither on threads nor on the way in which an engine looks for
// holes. Generator: Philox4x32-7 (Salmon et al., SC'11, doi:10.1145/2063384.2063405; the fewest
// rounds that pass BigCrush) from Random123.
#pragma once

#include "native/hopper/parameters.hpp"

#include <Random123/philox.h>

#include <array>
#include <cstdint>

namespace crossgrain::hopper {

using Philox = r123::Philox4x32_R<7>;

/// What a number is for; no two uses share numbers.
enum class Purpose : std::uint32_t { initial_state = 1, flips = 2, moves = 3, shared_stream = 4 };

/// Numbers of one site in one iteration.
struct MoveNumbers {
    std::uint32_t order =
        0;                  ///< holes of a level are filled in ascending order of it, then of site
    std::uint32_t tie = 0;  ///< chooses among equally good candidates
};

/// Uniform in 0..count-1; uneven by less than count 2^-32.
[[nodiscard]] constexpr std::uint32_t choose(std::uint32_t word, std::uint32_t count) noexcept {
    return static_cast<std::uint32_t>(std::uint64_t{word} * count >> 32);
}

class Numbers {
  public:
    explicit Numbers(const Parameters& p)
        : key_{{static_cast<std::uint32_t>(p.seed), static_cast<std::uint32_t>(p.seed >> 32)}},
          run_(p.run) {}

    [[nodiscard]] std::array<std::uint32_t, 4> block(std::uint32_t low, std::uint32_t high,
                                                     Purpose purpose) const {
        const auto words = Philox()({{low, high, run_, static_cast<std::uint32_t>(purpose)}}, key_);
        return {words[0], words[1], words[2], words[3]};
    }
    [[nodiscard]] MoveNumbers of_move(std::uint32_t iteration, std::uint32_t site) const {
        const auto words = block(site, iteration, Purpose::moves);
        return {.order = words[0], .tie = words[1]};
    }
    /// Number n of the shared stream.
    [[nodiscard]] std::uint32_t of_stream(std::uint64_t n) const {
        const std::uint64_t block_number = n / 4;
        return block(static_cast<std::uint32_t>(block_number),
                     static_cast<std::uint32_t>(block_number >> 32), Purpose::shared_stream)[n % 4];
    }

    [[nodiscard]] Philox::key_type key() const noexcept { return key_; }
    [[nodiscard]] std::uint32_t run() const noexcept { return run_; }

  private:
    Philox::key_type key_;
    std::uint32_t run_;
};

}  // namespace crossgrain::hopper
