// What every frame of the models on lattices must satisfy before an estimator sees it, as
// FrameGuard does for grains: the frames the scene asks for, in order and complete, and nothing
// lost on the way. All throw TrajectoryError.
#pragma once

#include "cases/scene/frame.hpp"
#include "cases/scene/gas_frame.hpp"
#include "cases/scene/hopper_automaton.hpp"
#include "cases/scene/hopper_frame.hpp"
#include "cases/scene/lattice_gas.hpp"
#include "cases/scene/scene.hpp"
#include "cases/scene/synthetic_signal.hpp"

#include <cstdint>
#include <vector>

namespace crossgrain::scene {

/// Schedule, shapes, particles at rest among those counted, no particle faster than one site per
/// step; in a periodic pipe the number of particles in each replica stays. Replicas are samples of
/// their own: no two of them may have had the same history, unless nothing ever changed in it.
class GasFrameGuard {
  public:
    explicit GasFrameGuard(const LatticeGas& scene);
    /// A signal has counts only, and they need not add up.
    explicit GasFrameGuard(const SyntheticSignal& scene);

    void operator()(const GasFrame& frame);
    /// To be called after the run: the last frame must have come, unless the pipe saturated.
    void finish() const;

  private:
    void check_schedule(const GasFrame& frame) const;
    void check_values(const GasFrame& frame) const;
    void check_number(const GasFrame& frame);
    void add_to_history(const GasFrame& frame);
    void check_history() const;

    GasSampling sampling_;
    bool number_stays_;
    std::int64_t expected_step_;
    bool saturated_ = false;
    std::vector<std::uint64_t> number_;          // in the first frame, shape (replicas)
    std::vector<std::uint64_t> history_, last_;  // digests of frames, shape (replicas)
    std::vector<bool> changed_;                  // shape (replicas)
};

/// Angles, replicas and iterations in their order; in each replica no grain appears or vanishes but
/// through the outlet.
class HopperFrameGuard {
  public:
    explicit HopperFrameGuard(const HopperAutomaton& scene) : scene_(scene) {}

    void operator()(const HopperFrame& frame);
    /// To be called after the run: the last frame of the last replica must have come.
    void finish() const;

  private:
    void check_schedule(const HopperFrame& frame) const;
    void check_number(const HopperFrame& frame);
    void expect_next(const HopperFrame& frame);

    const HopperAutomaton& scene_;
    std::size_t angle_index_ = 0;  // of the frame that must come next
    int replica_ = 0;
    std::int64_t iteration_ = 0;
    std::uint64_t grains_ = 0;  // of this replica, before the first iteration
};

/// Frames of grains have passed the FrameGuard of their adapter already.
struct NoGuard {
    void operator()(const Frame& /*frame*/) const {}
    void finish() const {}
};

[[nodiscard]] inline NoGuard lattice_guard(const Scene& /*scene*/) {
    return {};
}
[[nodiscard]] inline GasFrameGuard lattice_guard(const LatticeGas& scene) {
    return GasFrameGuard(scene);
}
[[nodiscard]] inline GasFrameGuard lattice_guard(const SyntheticSignal& scene) {
    return GasFrameGuard(scene);
}
[[nodiscard]] inline HopperFrameGuard lattice_guard(const HopperAutomaton& scene) {
    return HopperFrameGuard(scene);
}

}  // namespace crossgrain::scene
