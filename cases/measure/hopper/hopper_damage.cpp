#include "cases/measure/hopper/hopper_damage.hpp"

#include "cases/measure/hopper/hopper_replicas.hpp"
#include "native/numerics/mean_with_error.hpp"

#include <algorithm>
#include <stdexcept>

namespace crossgrain::measure {
namespace {

constexpr double damaged_above = 0.01;

double differing_share(const scene::HopperFrame& frame) {
    std::size_t differing = 0;
    for (std::size_t i = 0; i < frame.state.size(); ++i)
        differing += frame.state[i] != frame.twin[i] ? 1U : 0U;
    return static_cast<double>(differing) / static_cast<double>(frame.state.size());
}

double emptied_difference(const scene::HopperFrame& frame) {
    double either = 0, one = 0;
    for (std::size_t i = 0; i < frame.state.size(); ++i) {
        const bool here = frame.state[i] == 0, there = frame.twin[i] == 0;
        either += here || there ? 1 : 0;
        one += here != there ? 1 : 0;
    }
    return either == 0 ? 0 : one / either;
}

std::size_t damaged(const std::vector<double>& damage) {
    return static_cast<std::size_t>(
        std::ranges::count_if(damage, [](double share) { return share > damaged_above; }));
}

}  // namespace

HopperDamage::HopperDamage(const scene::HopperAutomaton& scene)
    : replicas_(static_cast<std::size_t>(scene.replicas)) {
    if (scene.angles.size() != 1) throw std::invalid_argument("the scene has more than one angle");
    if (scene.flipped < 1) throw std::invalid_argument("the scene has no twin: set 'flipped'");
}

void HopperDamage::add(const scene::HopperFrame& frame) {
    damage_[frame.iteration].push_back(differing_share(frame));
    if (frame.last) shape_difference_.push_back(emptied_difference(frame));
}

void HopperDamage::finish(Results& results) {
    if (shape_difference_.empty() || shape_difference_.size() < replicas_) return;
    const std::vector<double>& last = damage_.rbegin()->second;
    append_replica_mean(results, "damage", last);
    append_replica_mean(results, "shape_difference", shape_difference_);
    append_share(results, "damaged_trials", damaged(last), last.size(),
                 {{"damaged_above", damaged_above}});
    Series series{.name = "damage",
                  .columns = {"iteration", "damage", "standard_error", "damaged_trials"},
                  .values = std::vector<std::vector<double>>(4),
                  .units = {"iterations", "1", "1", "1"}};
    for (const auto& [iteration, damage] : damage_) {
        const numerics::MeanWithError mean = numerics::mean_with_error(damage);
        series.values[0].push_back(static_cast<double>(iteration));
        series.values[1].push_back(mean.value);
        series.values[2].push_back(mean.standard_error);
        series.values[3].push_back(static_cast<double>(damaged(damage)) /
                                   static_cast<double>(damage.size()));
    }
    results.series.push_back(std::move(series));
}

}  // namespace crossgrain::measure
