#include "cases/measure/collision/plate_bounce.hpp"

#include "cases/measure/bed/plate_motion.hpp"
#include "native/numerics/mean_with_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace crossgrain::measure {
namespace {

bool at_rest(const scene::PrescribedPlate& plate) {
    return plate.amplitude == 0;
}

bool measurable(const scene::Scene& scene) {
    const auto& plates = scene.plates;
    const auto* prescribed_lid = std::get_if<scene::PrescribedPlate>(&plates.lid);
    const bool no_lid = std::holds_alternative<std::monostate>(plates.lid);
    return scene.gravity == 0 && scene.grain_count() > 0 && (plates.bottom || !no_lid) &&
           (!plates.bottom || at_rest(*plates.bottom)) &&
           (!prescribed_lid || at_rest(*prescribed_lid)) &&
           std::ranges::none_of(scene.initial.frozen, [](bool f) { return f; });
}

}  // namespace

PlateBounce::PlateBounce(const scene::Scene& scene)
    : applicable_(measurable(scene)), plates_(scene.plates),
      reach_(plates_.touches == scene::PlateContact::surface ? scene.grains.diameter / 2 : 0.0),
      mass_(scene.grains.mass) {
    if (const auto* lid = std::get_if<scene::FreeLid>(&plates_.lid)) lid_mass_ = lid->mass;
}

std::vector<PlateBounce::GrainFlights> PlateBounce::flights(const scene::Frame& frame) const {
    // A plate that is not there is infinitely far away and never approached.
    const Flight none{frame.time, std::numeric_limits<double>::infinity(), 0.0, 0.0};
    const auto bottom = bottom_state(plates_, frame.time);
    const auto lid = lid_state(plates_, frame);
    const double lid_momentum = lid ? lid_mass_ * lid->velocity : 0.0;
    std::vector<GrainFlights> result(frame.y.size(), {none, none});
    for (std::size_t i = 0; i < frame.y.size(); ++i) {
        const double momentum = mass_ * frame.vy[i] + lid_momentum;
        if (bottom) {
            result[i].bottom = {frame.time, frame.y[i] - reach_ - bottom->height,
                                frame.vy[i] - bottom->velocity, momentum};
        }
        if (lid) {
            result[i].lid = {frame.time, lid->height - frame.y[i] - reach_,
                             lid->velocity - frame.vy[i], momentum};
        }
    }
    return result;
}

PlateBounce::Plate PlateBounce::target(const GrainFlights& first) {
    return first.bottom.gap_rate < first.lid.gap_rate ? Plate::bottom : Plate::lid;
}

void PlateBounce::add(const scene::Frame& frame) {
    if (!applicable_) return;
    (first_.empty() ? first_ : last_) = flights(frame);
}

std::optional<PlateBounce::Bounce> PlateBounce::bounce(const Flight& in, const Flight& out,
                                                       double reduced_mass) {
    const bool came = in.gap >= 0 && in.gap_rate < 0;
    const bool left = out.gap >= 0 && out.gap_rate > 0;
    if (!came || !left) return std::nullopt;
    const double arrival = in.time - in.gap / in.gap_rate;
    const double departure = out.time - out.gap / out.gap_rate;
    if (departure <= arrival) return std::nullopt;
    return Bounce{.restitution = -out.gap_rate / in.gap_rate,
                  .contact_time = departure - arrival,
                  .momentum_error =
                      (out.momentum - in.momentum) / (reduced_mass * std::abs(in.gap_rate))};
}

void PlateBounce::finish(Results& results) {
    if (!applicable_ || first_.empty()) return;
    const bool free_lid = lid_mass_ > 0;
    const auto on_lid = std::ranges::count_if(
        first_, [](const auto& grain) { return target(grain) == Plate::lid; });
    if (free_lid && on_lid > 1) return;

    std::vector<Bounce> complete;
    for (std::size_t i = 0; i < last_.size(); ++i) {
        const bool lid = target(first_[i]) == Plate::lid;
        const double mu = lid && free_lid ? mass_ * lid_mass_ / (mass_ + lid_mass_) : mass_;
        const auto found = lid ? bounce(first_[i].lid, last_[i].lid, mu)
                               : bounce(first_[i].bottom, last_[i].bottom, mu);
        if (found) complete.push_back(*found);
    }
    results.measurements.push_back({.observable = "complete_bounces",
                                    .value = static_cast<double>(complete.size()),
                                    .n = first_.size(),
                                    .settings = {}});
    if (complete.size() != first_.size()) return;
    const auto add_mean = [&](const std::string& name, double Bounce::*quantity,
                              const std::string& unit) {
        std::vector<double> samples;
        for (const Bounce& one : complete)
            samples.push_back(one.*quantity);
        const numerics::MeanWithError mean = numerics::mean_with_error(samples);
        results.measurements.push_back({.observable = name,
                                        .value = mean.value,
                                        .standard_error = mean.standard_error,
                                        .n = mean.n,
                                        .unit = unit,
                                        .settings = {}});
    };
    add_mean("plate_restitution", &Bounce::restitution, "1");
    add_mean("plate_contact_time", &Bounce::contact_time, "t");
    // A plate at rest takes up momentum; only a free lid and its one grain keep theirs.
    if (free_lid && on_lid == std::ssize(first_)) {
        add_mean("plate_momentum_error", &Bounce::momentum_error, "1");
    }
}

}  // namespace crossgrain::measure
