// A filling as engines hold it: the stored field, and what has left it.
#pragma once

#include "native/hopper/engine.hpp"
#include "native/hopper/geometry.hpp"
#include "native/hopper/parameters.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace crossgrain::hopper {

struct Filling {
    /// Full, with the initial orientations of the run. Throws CaseError, see check().
    explicit Filling(const Parameters& parameters);

    /// Step 1 of an iteration: the grains of the outlet leave; their number goes into the record.
    void empty_outlet();
    /// The outermost sites of level k count as vacated if they are empty.
    void note_reach(std::size_t k);
    /// 0 empty, 1 to 3 orientation; shape (sites).
    [[nodiscard]] std::vector<std::uint8_t> sites() const;

    Geometry geometry;
    std::vector<std::uint8_t> field;  ///< shape (geometry.stored())
    Record record;
};

}  // namespace crossgrain::hopper
