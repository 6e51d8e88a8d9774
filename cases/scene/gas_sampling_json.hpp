// Size, duration and sampling of a gas as JSON.
#pragma once

#include "cases/scene/gas_sampling.hpp"

#include <nlohmann/json_fwd.hpp>

namespace crossgrain::scene {

[[nodiscard]] nlohmann::json to_json(const GasSampling& sampling);

}  // namespace crossgrain::scene
