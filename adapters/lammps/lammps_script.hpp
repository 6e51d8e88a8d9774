// The input script of LAMMPS for a scene. Holds only what the scene needs: no walls, gravity, lid,
// friction or third type unless it has them.
#pragma once

#include "cases/scene/scene.hpp"

#include <string>

namespace crossgrain::adapters {

/// Frictional contacts of `granular` follow the conventions "lammps-granular", those of
/// `gran/hooke` and `gran/hooke/history` "lammps-hooke-history".
enum class PairStyle { granular, gran_hooke };

/// The style for a law; `granular` for a law without friction and where each code takes its own.
[[nodiscard]] PairStyle pair_style(const scene::ContactLaw& law);

/// Reads the initial state from `data_name` and writes the frames to `dump_name`. The scene must be
/// one that LAMMPS can express.
[[nodiscard]] std::string lammps_script(const scene::Scene& scene, const std::string& data_name,
                                        const std::string& dump_name);

}  // namespace crossgrain::adapters
