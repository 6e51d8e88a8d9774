// Where the plates of a scene are at the time of a frame.
#pragma once

#include "cases/scene/frame.hpp"
#include "cases/scene/scene.hpp"

#include <optional>

namespace crossgrain::measure {

/// Height and velocity of a plate; the lid's own type serves for both plates.
using PlateState = scene::LidState;

/// Prescribed plate at time t: height + b cos a, -b (2 pi/T) sin a, a = 2 pi (t/T + phase).
[[nodiscard]] PlateState plate_state(const scene::PrescribedPlate& plate, double t);

/// Nothing if the scene has no bottom.
[[nodiscard]] std::optional<PlateState> bottom_state(const scene::Plates& plates, double t);

/// Prescribed lids from the time, free lids from the frame. Nothing if there is no lid.
[[nodiscard]] std::optional<PlateState> lid_state(const scene::Plates& plates,
                                                  const scene::Frame& frame);

/// Period of the plate that moves, the bottom's if both do. Nothing if none does.
[[nodiscard]] std::optional<double> driving_period(const scene::Plates& plates);

}  // namespace crossgrain::measure
