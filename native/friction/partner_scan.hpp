// Which of a stretch of sorted discs a disc can touch within the margins of both, with the vectors
// of this machine. All instruction sets find the same, in the same order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace crossgrain::friction {

/// Discs sorted by cell. Shape of all arrays: (discs + padding).
struct SortedDiscs {
    static constexpr std::size_t padding = 16;  ///< readable numbers beyond the last disc
    std::vector<double> x, y;
    std::vector<double> radius;
    std::vector<double> margin_x, margin_y;
    std::vector<double> margin;  ///< the larger of the two; -1: frozen
};

/// The disc that looks.
struct Seeker {
    double x = 0, y = 0;  ///< seen from the cells of the stretch
    double radius = 0, margin_x = 0, margin_y = 0;
    double margin = 0;
    std::size_t place = 0;
};

/// Writes the numbers of the partners among begin ... end - 1 to `found`, which has room for all of
/// them, and returns how many there are. Of two mobile discs the one with the wider margin (of
/// equals, the later one) finds the other, so that it alone has to look that far.
using ScanForPartners = std::size_t (*)(const SortedDiscs& discs, const Seeker& seeker,
                                        std::size_t begin, std::size_t end, std::uint32_t* found);

/// The fastest one on this machine.
[[nodiscard]] ScanForPartners scan_for_partners_function();

}  // namespace crossgrain::friction
