#include "cases/measure/collision/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossgrain::measure {

Trajectory::Trajectory(const scene::Scene& scene, TrajectoryOptions options) {
    for (const double count : options.at_contact_times) {
        const double steps = count * scene::contact_time(scene) / scene.dt;
        const double nearest = std::round(steps);
        if (std::abs(steps - nearest) <= 1e-6) steps_.push_back(std::llround(nearest));
    }
    std::ranges::sort(steps_);
}

void Trajectory::add(const scene::Frame& frame) {
    if (!std::ranges::binary_search(steps_, frame.step)) return;
    snapshots_.push_back(
        {frame.time, {frame.x.begin(), frame.x.end()}, {frame.y.begin(), frame.y.end()}});
}

void Trajectory::finish(Results& results) {
    std::ranges::move(snapshots_, std::back_inserter(results.snapshots));
    snapshots_.clear();
}

}  // namespace crossgrain::measure
