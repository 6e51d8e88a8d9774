#include "cases/measure/gas/gas_energy.hpp"

#include "cases/measure/waves/over_samples.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace crossgrain::measure {
namespace {

constexpr std::size_t most_groups = 8;
constexpr std::size_t stretches = 50;
constexpr double near = 0.1, steady = 0.05;

// Means of groups of neighbouring replicas, as equal as can be.
std::vector<double> group_means(std::span<const double> samples, std::size_t groups) {
    std::vector<double> means;
    for (std::size_t g = 0; g < groups; ++g) {
        const std::size_t begin = g * samples.size() / groups;
        const std::size_t end = (g + 1) * samples.size() / groups;
        means.push_back(numerics::mean_with_error(samples.subspan(begin, end - begin)).value);
    }
    return means;
}

}  // namespace

GasEnergy::GasEnergy(const scene::GasSampling& sampling)
    : sampling_(sampling), rests_(static_cast<std::size_t>(sampling.replicas)),
      loss_(rests_.size()),
      third_(sampling.frames() / 2, sampling.frames() * 3 / 4 - 1, rests_.size()),
      fourth_(sampling.frames() * 3 / 4, sampling.frames() - 1, rests_.size()),
      fourth_rests_(sampling.frames() * 3 / 4, sampling.frames() - 1, rests_.size()),
      curve_(sampling.frames()), groups_(std::min(most_groups, rests_.size())) {
    if (!sampling.fields.rests) {
        throw std::invalid_argument("the energy needs the field 'rests'");
    }
    if (sampling.frames() < 8) throw std::invalid_argument("the energy needs eight frames or more");
}

void GasEnergy::add(const scene::GasFrame& frame) {
    std::ranges::fill(rests_, 0.0);
    for (std::size_t i = 0; i < frame.bins; ++i) {
        const auto bin = frame.rests.subspan(i * frame.replicas, frame.replicas);
        for (std::size_t r = 0; r < frame.replicas; ++r)
            rests_[r] += bin[r];
    }
    const double sites = static_cast<double>(sampling_.length) * sampling_.width;
    for (double& rests : rests_)
        rests /= sites;
    if (frame_ == 0) first_ = rests_;
    std::ranges::transform(rests_, first_, loss_.begin(), std::minus<>());
    third_.add(frame_, loss_);
    fourth_.add(frame_, loss_);
    fourth_rests_.add(frame_, rests_);
    curve_.add(frame_, frame.step, loss_);
    times_.push_back(static_cast<double>(frame.step));
    const auto means = group_means(loss_, groups_);
    group_loss_.insert(group_loss_.end(), means.begin(), means.end());
    ++frame_;
}

std::optional<double> GasEnergy::saturation_time(std::size_t group, double late) const {
    if (!(late > 0)) return std::nullopt;
    const std::size_t frames = times_.size(), count = std::min(stretches, frames);
    std::optional<double> since;
    for (std::size_t s = 0; s < count; ++s) {
        const std::size_t begin = s * frames / count, end = (s + 1) * frames / count;
        double mean = 0;
        for (std::size_t f = begin; f < end; ++f)
            mean += group_loss_[f * groups_ + group] / static_cast<double>(end - begin);
        if (std::abs(mean - late) > near * late) {
            since.reset();
        } else if (!since) {
            since = times_[begin];
        }
    }
    return since;
}

void GasEnergy::add_saturation(Results& results) const {
    const auto before = group_means(*third_.means(), groups_);
    const auto late = group_means(*fourth_.means(), groups_);
    std::vector<double> drifts, times;
    std::size_t saturated = 0;
    for (std::size_t g = 0; g < groups_; ++g) {
        const double scale = std::max(std::abs(late[g]), std::abs(before[g]));
        const double drift = scale > 0 ? (late[g] - before[g]) / scale : 0.0;
        drifts.push_back(drift);
        if (late[g] > 0 && std::abs(drift) < steady) ++saturated;
        if (const auto time = saturation_time(g, late[g])) times.push_back(*time);
    }
    results.measurements.push_back(over_samples("energy_loss_drift", drifts, "1"));
    results.measurements.push_back(fraction("energy_loss_saturates", saturated, groups_));
    if (times.size() == groups_) {
        results.measurements.push_back(over_samples("energy_saturation_time", times, "steps"));
    }
}

void GasEnergy::finish(Results& results) {
    if (frame_ == 0) return;
    results.series.push_back(curve_.series("energy-loss", "loss", "1/site"));
    const auto late = fourth_.means();
    if (!late || !third_.means()) return;
    results.measurements.push_back(
        over_samples("rests_per_site", *fourth_rests_.means(), "1/site"));
    results.measurements.push_back(over_samples("energy_loss_late", *late, "1/site"));
    add_saturation(results);
}

}  // namespace crossgrain::measure
