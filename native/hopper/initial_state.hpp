// The filling before the first iteration: every site occupied, orientations independent and
// uniform.
#pragma once

#include "native/hopper/parameters.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace crossgrain::hopper {

/// Orientations 1..3, shape (sites), from numbers of (seed, run, site); `flipped` different sites,
/// chosen at random by numbers of (seed, run), have one of their two other orientations instead.
/// Throws CaseError when more sites are to be flipped than there are.
[[nodiscard]] std::vector<std::uint8_t> initial_state(const Parameters& parameters,
                                                      std::size_t sites);

}  // namespace crossgrain::hopper
