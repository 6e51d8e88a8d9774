// The numbers of one run, from its frames one by one.
#pragma once

#include "cases/catalog/case.hpp"
#include "cases/measure/results.hpp"
#include "cases/observables/estimators.hpp"
#include "cases/scene/lattice_guard.hpp"

namespace crossgrain::run {

/// Throws TrajectoryError if a number is none: it must not reach a verdict.
void require_finite(const measure::Results& results);

/// The estimators of a case behind the guard of the scene's model (frames of grains must have
/// passed a FrameGuard).
template <class SceneT>
class FrameMeasurement {
  public:
    using Frame = typename scene::FrameOf<SceneT>::type;

    /// `scene` must outlive it. Throws CaseError for what cannot be measured in this scene.
    FrameMeasurement(const catalog::Case& the_case, const SceneT& scene)
        : estimators_(observables::make_estimators(the_case, scene)),
          guard_(scene::lattice_guard(scene)) {}

    /// Throws TrajectoryError for a frame that cannot be.
    void add(const Frame& frame) {
        guard_(frame);
        for (const auto& estimator : estimators_)
            estimator->add(frame);
    }

    /// To be called once, after the last frame. Throws TrajectoryError.
    [[nodiscard]] measure::Results finish() {
        guard_.finish();
        measure::Results results;
        for (const auto& estimator : estimators_)
            estimator->finish(results);
        require_finite(results);
        return results;
    }

  private:
    decltype(observables::make_estimators(std::declval<const catalog::Case&>(),
                                          std::declval<const SceneT&>())) estimators_;
    decltype(scene::lattice_guard(std::declval<const SceneT&>())) guard_;
};

}  // namespace crossgrain::run
