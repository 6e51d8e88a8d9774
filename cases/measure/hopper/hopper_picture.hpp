// Pictures of a hopper: one colour per orientation, and the free surface. Gremaud, Figs. 9 to 13.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"

#include <cstdint>
#include <vector>

namespace crossgrain::measure {

struct HopperPictureOptions {
    std::vector<std::int64_t> at = {};
    std::int64_t largest = 800;
};

inline OptionKeys option_keys(HopperPictureOptions& o) {
    return {{"at", &o.at, Range::whole(0), "iterations, frames of the scene; left out: the last"},
            {"largest", &o.largest, Range::whole(16, 4096), "pixels along the longer side"}};
}

/// Of the first replica at the first angle: pictures "orientation-<iteration>", to scale, gravity
/// down. White: emptied; light grey: outside; black: free surface (the highest grain of each
/// column); blue, yellow, red: orientations 1 (falling to the right), 2 (vertical), 3 (falling to
/// the left).
class HopperPicture final : public HopperEstimator {
  public:
    using Options = HopperPictureOptions;
    /// Throws std::invalid_argument for an iteration that is no frame, or pictures too small.
    explicit HopperPicture(const scene::HopperAutomaton& scene, HopperPictureOptions options = {});
    void add(const scene::HopperFrame& frame) override;
    void finish(Results& results) override;

  private:
    scene::HopperAutomaton scene_;
    HopperPictureOptions options_;
    std::vector<Picture> pictures_;
};

}  // namespace crossgrain::measure
