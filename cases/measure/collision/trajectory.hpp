// Positions at chosen times, for the comparison of trajectories between codes.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"

#include <vector>

namespace crossgrain::measure {

struct TrajectoryOptions {
    std::vector<double> at_contact_times = {};
};

inline OptionKeys option_keys(TrajectoryOptions& o) {
    return {{"at_contact_times", &o.at_contact_times, Range::not_negative(),
             "times in contact times, in any order"}};
}

/// One Snapshot per wanted time that is the time of a frame, in the order of the frames. A time is
/// matched to the step round(time/dt) if it is within 1e-6 dt of it (times are decimal numbers, a
/// step times dt is rounded); positions are never interpolated. A time without a frame gives
/// nothing.
class Trajectory final : public Estimator {
  public:
    using Options = TrajectoryOptions;
    Trajectory(const scene::Scene& scene, TrajectoryOptions options);
    void add(const scene::Frame& frame) override;
    void finish(Results& results) override;

  private:
    std::vector<std::int64_t> steps_;  ///< wanted steps, ascending
    std::vector<Snapshot> snapshots_;
};

}  // namespace crossgrain::measure
