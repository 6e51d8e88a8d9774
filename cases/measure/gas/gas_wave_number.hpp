// Spatial spectrum S(k) of a lattice gas (structure_factor.hpp), every replica a sample.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"
#include "cases/measure/waves/structure_factor.hpp"
#include "cases/scene/gas_sampling.hpp"

#include <cstdint>

namespace crossgrain::measure {

struct GasWaveNumberOptions {
    std::int64_t k_min = 1;
    std::int64_t k_max = 0;
    std::int64_t fields = 1000;
};

inline OptionKeys option_keys(GasWaveNumberOptions& o) {
    return {{"k_min", &o.k_min, Range::whole(1), "first k of the fit window"},
            {"k_max", &o.k_max, Range::whole(0),
             "last k, > k_min, at most half the bins; 0: a quarter"},
            {"fields", &o.fields, Range::whole(1), "most frames used, equally spaced"}};
}

/// What StructureFactor::append says. Nothing if the run ended early.
class GasWaveNumber final : public GasEstimator {
  public:
    using Options = GasWaveNumberOptions;
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
