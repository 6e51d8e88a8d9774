// The one list of closed forms that cases are held against. To add one, add a line in oracles.cpp.
#pragma once

#include "cases/scene/any_scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace crossgrain::oracles {

/// The exact value for a scene, e.g. "analytic:restitution". Nothing if the name is not known or
/// the closed form does not hold for this scene.
[[nodiscard]] std::optional<double> exact_value(const std::string& name,
                                                const scene::AnyScene& scene);
[[nodiscard]] std::vector<std::string> oracle_names();

}  // namespace crossgrain::oracles
