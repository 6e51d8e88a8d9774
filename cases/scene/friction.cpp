#include "cases/scene/friction.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace crossgrain::scene {
namespace {

/// As read in the sources of the codes and certified against the programs in
/// tests/adapters.
const std::array<std::pair<const char*, FrictionConventions>, 4> named{
    {{"lammps-granular",
      {.velocity_lever = Lever::radius,
       .torque_lever = Lever::contact_point,
       .rotation = SpringRotation::project_and_rescale,
       .limit = CoulombLimit::total}},
     {"lammps-hooke-history",
      {.velocity_lever = Lever::radius,
       .torque_lever = Lever::radius,
       .rotation = SpringRotation::project,
       .limit = CoulombLimit::total}},
     {"liggghts",
      {.velocity_lever = Lever::contact_point,
       .torque_lever = Lever::contact_point,
       .rotation = SpringRotation::project,
       .limit = CoulombLimit::spring_only}},
     {"yade",
      {.velocity_lever = Lever::contact_point,
       .torque_lever = Lever::contact_point,
       .rotation = SpringRotation::rotate,
       .limit = CoulombLimit::spring_only}}}};

}  // namespace

std::optional<FrictionConventions> conventions_named(const std::string& name) {
    for (const auto& [known, conventions] : named) {
        if (name == known) return conventions;
    }
    return std::nullopt;
}

std::string to_string(const FrictionConventions& conventions) {
    for (const auto& [name, known] : named) {
        if (conventions == known) return name;
    }
    return fmt::format("velocity lever {}, torque lever {}, spring {}, limit {}",
                       to_string(conventions.velocity_lever), to_string(conventions.torque_lever),
                       to_string(conventions.rotation), to_string(conventions.limit));
}

}  // namespace crossgrain::scene
