// The start of a run as a LAMMPS data file, which LAMMPS and LIGGGHTS read alike.
#pragma once

#include "cases/scene/scene.hpp"

#include <string>

namespace crossgrain::adapters::dump {

/// Numbers of the atom types in use; 0 for what the scene does not have.
struct AtomTypes {
    int grain = 1;   ///< grains that move
    int frozen = 0;  ///< grains that never move
    int lid = 0;     ///< the one atom that stands for a free lid
    [[nodiscard]] int count() const noexcept { return 1 + (frozen > 0) + (lid > 0); }
};

[[nodiscard]] AtomTypes atom_types(const scene::Scene& scene);

/// Atoms (style sphere alias granular: id type diameter density x y z) and Velocities, numbers with
/// 17 significant digits. Grains have ids 1 ... N in the order of the scene, the lid has N + 1.
/// Frozen grains have velocity 0 and do not rotate. Masses are set by the input script: a density
/// would round them.
[[nodiscard]] std::string data_file(const scene::Scene& scene);

}  // namespace crossgrain::adapters::dump
