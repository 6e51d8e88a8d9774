// From the state that a preparation has left to the one a run starts from.
#pragma once

#include "cases/scene/scene.hpp"

namespace crossgrain::scene {

/// The scene without the grains its preparation removes, nothing prepared, and otherwise as it is:
/// the walls that the run will have. A scene without a preparation is returned unchanged.
[[nodiscard]] Scene without_removed(Scene scene);

/// The scene as a run starts from `settled`, which has shape (grains) of the given scene: all at
/// rest, the removed grains gone, and with them frozen grains above the highest one that moves. All
/// is dilated about the origin, walls and all, as little as leaves no contact: a code must not
/// start with contacts, whose springs it would not know.
[[nodiscard]] Scene start_of_run(Scene scene, const InitialState& settled);

/// The factor by which positions must grow so that no two grains (but two frozen ones) touch; 1
/// when none does.
[[nodiscard]] double contact_free_dilation(const Scene& scene);

}  // namespace crossgrain::scene
