// A scene of the lattice gas in the words of the engine.
#pragma once

#include "cases/scene/lattice_gas.hpp"
#include "native/lga/model.hpp"

namespace crossgrain::adapters {

[[nodiscard]] lga::Model gas_model(const scene::LatticeGas& scene);

}  // namespace crossgrain::adapters
