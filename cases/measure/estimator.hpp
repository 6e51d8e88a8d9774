// The interface of all observables: fed frame by frame, asked once at the end.
#pragma once

#include "cases/measure/results.hpp"
#include "cases/scene/any_scene.hpp"

namespace crossgrain::measure {

/// An estimator is built for one scene and used for one run.
template <class FrameT>
class EstimatorOf {
  public:
    using Frame = FrameT;
    virtual ~EstimatorOf() = default;
    virtual void add(const FrameT& frame) = 0;
    /// Appends what was measured. An estimator without enough data appends nothing; the verdict
    /// is then `undecided`, never a made-up number.
    virtual void finish(Results& results) = 0;
};

using Estimator = EstimatorOf<scene::Frame>;  ///< of grains
using GasEstimator = EstimatorOf<scene::GasFrame>;
using HopperEstimator = EstimatorOf<scene::HopperFrame>;

}  // namespace crossgrain::measure
