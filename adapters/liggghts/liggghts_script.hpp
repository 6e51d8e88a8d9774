// The input script of LIGGGHTS for a scene. Holds only what the scene needs: no plates, gravity,
// lid, spins or third type unless it has them.
#pragma once

#include "cases/scene/scene.hpp"

#include <string>

namespace crossgrain::adapters {

/// Reads the initial state from `data_name` and writes the frames to `dump_name`. The scene must be
/// one that LIGGGHTS can express.
[[nodiscard]] std::string liggghts_script(const scene::Scene& scene, const std::string& data_name,
                                          const std::string& dump_name);

/// Whether the law has a dashpot along the contact (full-vector damping with eta > 0).
[[nodiscard]] bool has_tangential_dashpot(const scene::ContactLaw& law);

}  // namespace crossgrain::adapters
