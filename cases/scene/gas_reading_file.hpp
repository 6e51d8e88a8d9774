// A reading of the lattice gas's rules as a TOML file -> GasReading.
//
//   text = "..."
//   walls = "outside"                  # or "inside": where the two wall columns are
//   relocation = "origin-first"        # or "random-walk"
//   gravity = { rest_to_down = true, up_diagonals = true, up_to_rest = true, on_walls = false }
//   collision = [
//     { from = "i i+3", to = "i+1 i+4", probability = "(1-p)/2" },
//     { from = "0 3 R", to = "R R R" },
//   ]
//
// Directions are those of lattice_gas.hpp. A row with i stands for its six rotations and their
// mirror images (`mirror = false`: rotations only), images that coincide counting once. Without
// `probability` it is 1. With `spectators = true` the row also holds when other movers are there.
#pragma once

#include "cases/scene/lattice_gas.hpp"

#include <string>

namespace crossgrain::scene {

/// Reads and checks a table: mass, momentum, at most one rest particle before, probabilities in
/// [0, 1] and their sum over the rows of a configuration at most 1 for every p in [0, 1]. The
/// reading's name is the file's without ".toml". Throws CaseError with the line of the row.
[[nodiscard]] GasReading load_gas_reading(const std::string& file);

}  // namespace crossgrain::scene
