// A prepared state as it is kept: the places of all grains, in JSON.
#pragma once

#include "cases/scene/initial_state.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace crossgrain::scene {

/// Positions of so many grains. Throws std::invalid_argument, with one line, for text that is not
/// such a state as a whole: cut off, nested, short of a grain, not finite.
[[nodiscard]] InitialState state_from(std::string_view text, std::size_t grains);

/// Reads back to the same bits. `rms_speed` is what was left of motion, for whoever looks.
[[nodiscard]] std::string text_of(const InitialState& state, double rms_speed);

}  // namespace crossgrain::scene
