// Writes frames as a LAMMPS text dump, the neutral trajectory format: columns id type xu yu vx vy
// and, when the scene has friction, omegaz; numbers with 17 significant digits, so that reading
// gives back the same bits.
#pragma once

#include "cases/scene/frame.hpp"
#include "cases/scene/scene.hpp"

#include <ostream>
#include <string>

namespace crossgrain::adapters::dump {

/// Grains have type 1 and ids 1 ... N; a free lid has type 2 and id N + 1, at x = 0.
/// Frames of a scene with friction must hold angular velocities.
class DumpWriter {
  public:
    /// `scene` and `out` must outlive the writer.
    DumpWriter(const scene::Scene& scene, std::ostream& out);

    /// Appends one frame. Throws std::ios_base::failure if it cannot be written.
    void operator()(const scene::Frame& frame);

  private:
    const scene::Scene& scene_;
    std::ostream& out_;
};

}  // namespace crossgrain::adapters::dump
