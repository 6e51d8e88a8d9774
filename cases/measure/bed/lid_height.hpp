// Height of the lid as a function of time, and its mean.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"

#include <optional>
#include <vector>

namespace crossgrain::measure {

struct LidHeightOptions {
    double skip = 0;
};

inline OptionKeys option_keys(LidHeightOptions& o) {
    return {{"skip", &o.skip, Range::not_negative(),
             "time (t) left out of the mean at the start; the series keeps it"}};
}

/// Series "lid-height": t, h and, if the scene has a bottom, bottom and spacing = h - bottom (the
/// spacing Delta h of Taguchi, chao-dyn/9405003 (1994), Fig. 2). For a free lid as well as for a
/// prescribed one. Measurement `mean_lid_height` (l), time mean from t = skip on (time_mean.hpp;
/// over whole periods if driven), n the number of independent blocks; absent when the run is too
/// short to tell its error. Nothing without a lid.
class LidHeight final : public Estimator {
  public:
    using Options = LidHeightOptions;
    explicit LidHeight(const scene::Scene& scene, LidHeightOptions options = {});
    void add(const scene::Frame& frame) override;
    void finish(Results& results) override;

  private:
    LidHeightOptions options_;
    scene::Plates plates_;
    std::vector<double> time_, height_, bottom_;  ///< shape (frames)
};

}  // namespace crossgrain::measure
