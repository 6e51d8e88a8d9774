// The input script of LIGGGHTS for a scene. Holds only what the scene needs: no plates, gravity,
// lid, spins, friction or third type unless it has them.
#pragma once

#include "cases/scene/scene.hpp"

#include <string>

namespace crossgrain::adapters {

/// Reads the initial state from `data_name` and writes the frames to `dump_name`. The scene must be
/// one that LIGGGHTS can express.
[[nodiscard]] std::string liggghts_script(const scene::Scene& scene, const std::string& data_name,
                                          const std::string& dump_name);

}  // namespace crossgrain::adapters
