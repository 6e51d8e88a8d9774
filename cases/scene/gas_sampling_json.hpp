// Size, duration and sampling of a gas as JSON.
#pragma once

#include "cases/scene/gas_sampling.hpp"

#include <nlohmann/json.hpp>

namespace crossgrain::scene {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(GasFields, count, rests, momentum)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(GasSampling, length, width, periodic, bin, replicas, burn_in,
                                   steps, every, fields)

}  // namespace crossgrain::scene
