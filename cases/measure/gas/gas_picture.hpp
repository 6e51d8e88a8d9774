// Density in space and time as a picture in shades of grey (Peng & Herrmann 1995, Figs. 2b, 11a).
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"
#include "cases/scene/gas_sampling.hpp"

#include <cstdint>
#include <vector>

namespace crossgrain::measure {

struct GasPictureOptions {
    std::int64_t replica = 0;
    std::int64_t rows = 500;
};

inline OptionKeys option_keys(GasPictureOptions& o) {
    return {{"replica", &o.replica, Range::whole(0), "which one of the ensemble is shown"},
            {"rows", &o.rows, Range::whole(2, 2000), "most instants shown, equally spaced"}};
}

/// Picture "space-time": one pixel per bin from left to right (along gravity) and one row per
/// instant, time increasing upwards. The shade is linear in n_i, white for the least and black for
/// the greatest n_i of the picture.
class GasPicture final : public GasEstimator {
  public:
    using Options = GasPictureOptions;
    /// Throws std::invalid_argument for options out of range or without the field `count`.
    GasPicture(const scene::GasSampling& sampling, GasPictureOptions options);
    void add(const scene::GasFrame& frame) override;
    void finish(Results& results) override;

  private:
    scene::GasSampling sampling_;
    GasPictureOptions options_;
    std::int64_t stride_, frame_ = 0;
    std::int64_t first_step_ = 0, last_step_ = 0;
    std::vector<std::uint16_t> density_;  ///< shape (instants, bins)
};

}  // namespace crossgrain::measure
