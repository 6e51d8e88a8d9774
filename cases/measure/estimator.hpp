// The interface of all observables: fed frame by frame, asked once at the end.
#pragma once

#include "cases/measure/results.hpp"
#include "cases/scene/frame.hpp"
#include "cases/scene/scene.hpp"

namespace crossgrain::measure {

/// An estimator is built for one scene and used for one run.
class Estimator {
  public:
    virtual ~Estimator() = default;
    virtual void add(const scene::Frame& frame) = 0;
    /// Appends what was measured. An estimator without enough data appends nothing; the verdict
    /// is then `undecided`, never a made-up number.
    virtual void finish(Results& results) = 0;
};

}  // namespace crossgrain::measure
