#include "native/hopper/candidate_table.hpp"

#include "native/hopper/neighbourhood.hpp"

namespace crossgrain::hopper {

CandidateTable::CandidateTable(const Energies& energies) : entries_(1U << 18) {
    for (std::uint32_t number = 0; number < neighbourhoods; ++number) {
        const Cell cell = neighbourhood(number);
        std::uint16_t entry = best_candidates(cell, energies);
        if (cell[5] == 0 || cell[6] == 0 || cell[7] == 0) entry |= hole_below;
        entries_[index(cell[2], cell[3], cell[4], cell[5], cell[6], cell[7])] = entry;
    }
}

}  // namespace crossgrain::hopper
