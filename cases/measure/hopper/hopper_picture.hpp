// Pictures of a hopper: one colour per orientation, and the free surface. Gremaud, Figs. 9 to 13.
#pragma once

#include "cases/measure/estimator.hpp"

#include <cstdint>
#include <vector>

namespace crossgrain::measure {

struct HopperPictureOptions {
    std::vector<std::int64_t> at = {};  ///< iterations, frames of the scene; empty: the last
    std::size_t largest = 800;          ///< pixels along the longer side, at least 16
};

/// Of the first replica at the first angle: pictures "orientation-<iteration>", to scale, gravity
/// down. White: emptied; light grey: outside; black: free surface (the highest grain of each
/// column); blue, yellow, red: orientations 1 (falling to the right), 2 (vertical), 3 (falling to
/// the left).
class HopperPicture final : public HopperEstimator {
  public:
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
