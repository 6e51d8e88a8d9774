// The energy rule as a table: a move depends on the states of six neighbours only, so the best
// candidates of all 5^6 = 15,625 neighbourhoods can be worked out once.
#pragma once

#include "native/hopper/energy.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace crossgrain::hopper {

class CandidateTable {
  public:
    explicit CandidateTable(const Energies& energies);

    /// Neighbourhoods are numbered by three bits per node, which is quicker to put together than
    /// digits to base 5; the other 2^18 - 5^6 entries are not used.
    [[nodiscard]] static constexpr std::uint32_t index(std::uint32_t n2, std::uint32_t n3,
                                                       std::uint32_t n4, std::uint32_t n5,
                                                       std::uint32_t n6,
                                                       std::uint32_t n7) noexcept {
        return (n2 + 8 * n4) + ((n3 + 8 * n6) << 12) + ((n7 + 8 * n5) << 6);
    }
    /// best_candidates(), and `hole_below` if one of the nodes 5, 6, 7 is empty.
    [[nodiscard]] const std::uint16_t* entries() const noexcept { return entries_.data(); }

    static constexpr std::uint16_t candidates = (1U << candidate_count) - 1;
    static constexpr std::uint16_t hole_below = 1U << candidate_count;

  private:
    std::vector<std::uint16_t> entries_;
};

/// The candidates in a mask as a list: their number in the lowest four bits, then four bits per
/// candidate, ascending: 4 (source - 2) + orientation.
class CandidateLists {
  public:
    constexpr CandidateLists() {
        for (std::size_t mask = 0; mask < lists_.size(); ++mask) {
            std::uint64_t count = 0, list = 0;
            for (int number = 0; number < candidate_count; ++number) {
                if ((mask >> number & 1) == 0) continue;
                const Candidate c = candidate_of(number);
                const int code = 4 * (c.source - 2) + c.orientation;  // four bits
                list |= std::uint64_t(code) << (4 * ++count);
            }
            lists_[mask] = list | count;
        }
    }
    [[nodiscard]] constexpr std::uint64_t operator[](std::size_t mask) const noexcept {
        return lists_[mask];
    }

  private:
    std::array<std::uint64_t, 1U << candidate_count> lists_{};
};

inline constexpr CandidateLists candidate_lists;

}  // namespace crossgrain::hopper
