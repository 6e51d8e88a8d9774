// Energies as integers. Near ties are decided at the edge (C_O = eps = 0.001 is in the paper),
// where a rounded sum would decide by chance.
#pragma once

#include <cstdint>

namespace crossgrain::hopper {

/// An energy in units of 10^-12.
using Energy = std::int64_t;

/// Of one coefficient: the energy of a configuration adds up at most 13 of them and stays far below
/// the largest integer.
inline constexpr double largest_coefficient = 1e5;

/// The decimal number that `value` stands for (the shortest that reads back as `value`, so 0.1 is
/// exactly 10^11 units). Throws CaseError, naming `key`, when it is not in [0, 1e5] or has more
/// than 12 digits after the point.
[[nodiscard]] Energy to_energy(double value, const char* key);

}  // namespace crossgrain::hopper
