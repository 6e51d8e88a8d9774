// Spatial spectrum S(k) of a lattice gas (structure_factor.hpp), every replica a sample.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/waves/structure_factor.hpp"
#include "cases/scene/gas_sampling.hpp"

#include <cstdint>

namespace crossgrain::measure {

struct GasWaveNumberOptions {
    std::int64_t k_min = 1;      ///< >= 1
    std::int64_t k_max = 0;      ///< > k_min, <= K/2; 0: K/4
    std::int64_t fields = 1000;  ///< frames used at most, equally spaced, >= 1
};

/// What StructureFactor::append says. Nothing if the run ended early.
class GasWaveNumber final : public GasEstimator {
  public:
    /// Throws std::invalid_argument without the field `count`, unless fields >= 1, and for what
    /// StructureFactor refuses.
    GasWaveNumber(const scene::GasSampling& sampling, GasWaveNumberOptions options);
    void add(const scene::GasFrame& frame) override;
    void finish(Results& results) override;

  private:
    std::int64_t frames_, frame_ = 0, stride_ = 1;
    StructureFactor factor_;
};

}  // namespace crossgrain::measure
