// Scenes on which the stability of integrators is tried out.
#pragma once

#include "cases/scene/scene.hpp"
#include "reference/analytic/closed_packing.hpp"

namespace crossgrain::studies {

/// Whether the contacts of a test packing can open.
enum class ContactState { closed, open };

/// A small triangular lattice with the grains and the contact law of `model`: between its plates,
/// at rest, if its lid is prescribed; periodic along both axes otherwise. No gravity. Closed:
/// compressed by 1e-4 d, velocities 1e-6. Open: without overlap, velocities 0.1. Without dt and
/// schedule.
[[nodiscard]] scene::Scene packing_scene(const scene::Scene& model, ContactState state);

/// The same law with another restitution at the same contact time and damping direction.
[[nodiscard]] scene::ContactLaw with_restitution(const scene::Scene& model, double restitution);

/// The packing as the closed forms see it.
[[nodiscard]] analytic::ClosedPacking closed_packing(const scene::Scene& packing);

/// Whether the scene is a bed or a lattice: has a bottom plate and a period along x.
[[nodiscard]] bool can_be_narrowed(const scene::Scene& model);

/// `model` in a quarter of its width (with a quarter of a free lid's mass), from a lattice or a
/// packing as the shipped cases start. Throws std::invalid_argument if it cannot be narrowed.
[[nodiscard]] scene::Scene narrow_scene(const scene::Scene& model);

}  // namespace crossgrain::studies
