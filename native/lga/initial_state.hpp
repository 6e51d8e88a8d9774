// How a pipe is filled.
#pragma once

#include "native/lga/geometry.hpp"
#include "native/lga/model.hpp"

#include <cstdint>
#include <vector>

namespace crossgrain::lga {

/// N = round(rho L W).
[[nodiscard]] std::int64_t particles(const Model& model);

/// Packed sites of one replica, shape (columns, rows). A periodic pipe holds N particles in random
/// moving states, all sets equally likely (at wall sites the two states that arrive there);
/// what the moving states cannot hold is at rest. An open pipe is empty.
/// Throws CaseError when N exceeds the number of states.
[[nodiscard]] std::vector<std::uint8_t> initial_state(const Model& model, int replica);

}  // namespace crossgrain::lga
