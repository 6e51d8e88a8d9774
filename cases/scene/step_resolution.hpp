// Whether the time step of a scene can be stable in each of its contacts.
#pragma once

#include "cases/scene/scene.hpp"

#include <optional>
#include <string>

namespace crossgrain::scene {

/// Names the contact (lightest pair, lightest grain at a plate, lid on a grain) with the smallest
/// limit if dt reaches it: 2/omega, omega = sqrt(k/m_eff), at which a step of the Verlet family in
/// a single contact without damping becomes unstable (Hairer, Lubich & Wanner, Geometric Numerical
/// Integration, 2nd ed. (2006), I.5.2), 2 sqrt(2)/omega for Runge-Kutta. A packing has lower limits
/// (reference/analytic/packing_stability.hpp); this one no state of the scene survives.
[[nodiscard]] std::optional<std::string> why_not_resolved(const Scene& scene);

}  // namespace crossgrain::scene
