#include "cases/measure/bed/energy_balance.hpp"

#include "cases/measure/bed/plate_motion.hpp"
#include "cases/measure/statistics/hermite.hpp"
#include "cases/measure/statistics/time_mean.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace crossgrain::measure {
namespace {

std::optional<scene::PrescribedPlate> prescribed_lid(const scene::Plates& plates) {
    const auto* plate = std::get_if<scene::PrescribedPlate>(&plates.lid);
    return plate ? std::optional(*plate) : std::nullopt;
}

// Power taken out by one contact, -(F - F_spring) . v_rel; see the header for the variants.
double dissipated_power(const scene::ContactLaw& law, double overlap, double normal_speed,
                        double tangential_speed_squared) {
    const bool full = law.damping_acts_on == scene::Damping::full_vector;
    const double drag = full ? law.damping * tangential_speed_squared : 0.0;
    const bool attractive = law.stiffness * overlap < law.damping * normal_speed;
    if (law.clipping == scene::Clipping::none || !attractive) {
        return law.damping * normal_speed * normal_speed + drag;
    }
    const double given_up = law.stiffness * overlap * normal_speed;
    return law.clipping == scene::Clipping::all ? given_up : given_up + drag;
}

}  // namespace

EnergyBalance::EnergyBalance(const scene::Scene& scene, EnergyBalanceOptions options)
    : options_(options), driven_(driving_period(scene.plates).has_value()), grains_(scene.grains),
      contact_(scene.contact), plates_(scene.plates), gravity_(scene.gravity),
      grain_count_(scene.grain_count()), period_x_(scene.periodic_x), frozen_(scene.initial.frozen),
      contacts_(scene.grains.diameter, scene.periodic_x, scene.periodic_y) {
    const double interval = scene.dt * static_cast<double>(scene.frame_every);
    const double frames_per_contact_time = scene::contact_time(scene) / interval;
    const double least = options_.accurate_within ? 0 : options_.least_frames_per_contact_time;
    applicable_ = std::isfinite(frames_per_contact_time) &&
                  frames_per_contact_time >= least * (1 - 1e-9) &&
                  scene.contact.spins == scene::Spins::off;
    check_ranges(options_);
    samples_per_contact_time_ = frames_per_contact_time * options_.samples_per_frame;
}

void EnergyBalance::add_motion(const scene::Frame& frame, Sample& sample) const {
    const double m = grains_.mass;
    for (std::size_t i = 0; i < frame.x.size(); ++i) {
        sample.kinetic += m / 2 * (frame.vx[i] * frame.vx[i] + frame.vy[i] * frame.vy[i]);
        sample.gravity += m * gravity_ * frame.y[i];
    }
    const auto* lid = std::get_if<scene::FreeLid>(&plates_.lid);
    if (lid && frame.lid) {
        sample.kinetic += lid->mass / 2 * frame.lid->velocity * frame.lid->velocity;
        sample.gravity += lid->mass * gravity_ * frame.lid->height;
    }
}

void EnergyBalance::add_pairs(const scene::Frame& frame, Sample& sample) {
    for (const scene::Contact& c : contacts_.find(frame.x, frame.y)) {
        const double overlap = grains_.diameter - c.distance;
        const double vx = frame.vx[c.i] - frame.vx[c.j];
        const double vy = frame.vy[c.i] - frame.vy[c.j];
        const double normal = vx * c.nx + vy * c.ny;
        const double tangential = vy * c.nx - vx * c.ny;
        // Contacts between frozen grains do not change and would only add a constant.
        if (!frozen_.empty() && frozen_[c.i] && frozen_[c.j]) continue;
        sample.elastic += contact_.stiffness / 2 * overlap * overlap;
        sample.dissipated_power +=
            dissipated_power(contact_, overlap, normal, tangential * tangential);
    }
}

void EnergyBalance::add_plates(const scene::Frame& frame, Sample& sample) const {
    const double reach =
        plates_.touches == scene::PlateContact::surface ? grains_.diameter / 2 : 0.0;
    const auto bottom = bottom_state(plates_, frame.time);
    const auto lid = lid_state(plates_, frame);
    // A free lid is part of the system: what it gives to a grain it loses itself.
    const double lid_drive = prescribed_lid(plates_) ? lid->velocity : 0.0;
    for (std::size_t i = 0; i < frame.y.size(); ++i) {
        if (!frozen_.empty() && frozen_[i]) continue;
        if (bottom) {
            const double overlap = std::max(0.0, bottom->height - (frame.y[i] - reach));
            sample.elastic += plates_.stiffness / 2 * overlap * overlap;
            sample.input_power += plates_.stiffness * overlap * bottom->velocity;
        }
        if (lid) {
            const double overlap = std::max(0.0, frame.y[i] + reach - lid->height);
            sample.elastic += plates_.stiffness / 2 * overlap * overlap;
            sample.input_power -= plates_.stiffness * overlap * lid_drive;
        }
    }
}

EnergyBalance::Sample EnergyBalance::sample(const scene::Frame& frame) {
    Sample sample{.time = frame.time};
    add_motion(frame, sample);
    add_pairs(frame, sample);
    add_plates(frame, sample);
    return sample;
}

void EnergyBalance::store(const scene::Frame& frame, Instant& instant) const {
    instant.time = frame.time;
    instant.x.assign(frame.x.begin(), frame.x.end());
    instant.y.assign(frame.y.begin(), frame.y.end());
    instant.vx.assign(frame.vx.begin(), frame.vx.end());
    instant.vy.assign(frame.vy.begin(), frame.vy.end());
    instant.lid = frame.lid;
}

void EnergyBalance::add_between(const Instant& a, const scene::Frame& b) {
    const double h = b.time - a.time;
    Instant& m = between_;
    store(b, m);
    for (int part = 1; part < options_.samples_per_frame; ++part) {
        const double s = static_cast<double>(part) / options_.samples_per_frame;
        for (std::size_t i = 0; i < a.x.size(); ++i) {
            m.x[i] = hermite(s, h, a.x[i], a.vx[i], b.x[i], b.vx[i]);
            m.y[i] = hermite(s, h, a.y[i], a.vy[i], b.y[i], b.vy[i]);
            m.vx[i] = hermite_slope(s, h, a.x[i], a.vx[i], b.x[i], b.vx[i]);
            m.vy[i] = hermite_slope(s, h, a.y[i], a.vy[i], b.y[i], b.vy[i]);
        }
        if (a.lid && b.lid) {
            const auto& [y0, v0] = *a.lid;
            const auto& [y1, v1] = *b.lid;
            m.lid =
                scene::LidState{hermite(s, h, y0, v0, y1, v1), hermite_slope(s, h, y0, v0, y1, v1)};
        }
        samples_.push_back(sample({.step = b.step,
                                   .time = a.time + s * h,
                                   .x = m.x,
                                   .y = m.y,
                                   .vx = m.vx,
                                   .vy = m.vy,
                                   .lid = m.lid}));
    }
}

void EnergyBalance::add(const scene::Frame& frame) {
    if (!applicable_) return;
    if (options_.samples_per_frame > 1) {
        if (previous_) {
            add_between(*previous_, frame);
        } else {
            previous_ = Instant{};
        }
        store(frame, *previous_);
    }
    samples_.push_back(sample(frame));
}

EnergyBalance::Balance EnergyBalance::integrate(std::size_t stride, std::size_t end) const {
    Balance balance;
    for (std::size_t i = 0; i + stride <= end; i += stride) {
        const Sample& a = samples_[i];
        const Sample& b = samples_[i + stride];
        const double half = (b.time - a.time) / 2;
        balance.input += half * (a.input_power + b.input_power);
        balance.dissipated += half * (a.dissipated_power + b.dissipated_power);
    }
    balance.change = samples_[end].total() - samples_[0].total();
    return balance;
}

double EnergyBalance::scale(const Balance& balance) const {
    if (driven_ && balance.input != 0) return std::abs(balance.input);
    if (balance.dissipated > 0) return balance.dissipated;
    double largest = 0;
    for (const Sample& sample : samples_) {
        largest = std::max(largest, sample.kinetic + sample.elastic);
    }
    return largest;
}

void EnergyBalance::add_averages(Results& results) const {
    std::vector<double> times;
    for (const Sample& sample : samples_)
        times.push_back(sample.time);
    const auto mean_of = [&](const std::string& name, const std::string& unit,
                             auto quantity) -> std::optional<Measurement> {
        std::vector<double> values;
        for (const Sample& sample : samples_)
            values.push_back(quantity(sample));
        const auto mean = time_mean(times, values, options_.skip, driving_period(plates_));
        if (!mean) return std::nullopt;
        return Measurement{.observable = name,
                           .value = mean->value,
                           .standard_error = mean->standard_error,
                           .n = mean->blocks,
                           .unit = unit,
                           .settings = {{"skip", options_.skip}}};
    };
    const auto energy =
        mean_of("mean_energy", "m l^2/t^2", [](const Sample& s) { return s.total(); });
    const auto input =
        mean_of("mean_energy_input", "m l^2/t^3", [](const Sample& s) { return s.input_power; });
    const auto dissipation = mean_of("mean_dissipation", "m l^2/t^3",
                                     [](const Sample& s) { return s.dissipated_power; });
    for (const auto& mean : {energy, input, dissipation}) {
        if (mean) results.measurements.push_back(*mean);
    }
    if (energy && input) add_comparison_with_input(*energy, *input, results);
}

/// Potential energy of rigid grains in the closest packing, and of the lid on top of it.
std::optional<double> EnergyBalance::ground_energy() const {
    const bool driven_bottom = plates_.bottom && plates_.bottom->amplitude > 0;
    if (!driven_bottom || gravity_ == 0 || !period_x_ || !frozen_.empty()) return std::nullopt;
    const double d = grains_.diameter;
    const auto columns = static_cast<std::size_t>(*period_x_ / d * (1 + 1e-12));
    if (columns == 0 || grain_count_ == 0) return std::nullopt;
    const double reach = plates_.touches == scene::PlateContact::surface ? d / 2 : 0.0;
    const auto height = [&](std::size_t grain) {
        return plates_.bottom->height + reach +
               std::numbers::sqrt3 / 2 * d * static_cast<double>(grain / columns);
    };
    double energy = 0;
    for (std::size_t i = 0; i < grain_count_; ++i)
        energy += grains_.mass * gravity_ * height(i);
    if (const auto* lid = std::get_if<scene::FreeLid>(&plates_.lid)) {
        energy += lid->mass * gravity_ * (height(grain_count_ - 1) + reach);
    }
    return energy;
}

void EnergyBalance::add_comparison_with_input(const Measurement& energy, const Measurement& input,
                                              Results& results) const {
    const auto ground = ground_energy();
    if (!ground || !(input.value > 0)) return;
    const double period = plates_.bottom->period;
    Measurement above = energy;
    above.observable = "energy_above_ground";
    above.value -= *ground;
    above.settings["ground_energy"] = *ground;
    Measurement per_period = input;
    per_period.observable = "input_per_period";
    per_period.value *= period;
    per_period.standard_error *= period;
    per_period.unit = above.unit;
    Measurement ratio = above;
    ratio.observable = "energy_per_input";
    ratio.value = above.value / per_period.value;
    ratio.standard_error =
        std::hypot(above.standard_error, ratio.value * per_period.standard_error) /
        per_period.value;
    ratio.n = std::min(above.n, per_period.n);
    ratio.unit = "1";
    results.measurements.insert(results.measurements.end(), {above, per_period, ratio});
}

void EnergyBalance::add_series(Results& results) const {
    Series series{.name = "energy",
                  .columns = {"t", "kinetic", "gravity", "elastic", "input", "dissipated"},
                  .values = std::vector<std::vector<double>>(6)};
    constexpr std::size_t most_rows = 2000;
    const std::size_t stride = (samples_.size() + most_rows - 1) / most_rows;
    Balance so_far;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        const Sample& s = samples_[i];
        if (i > 0) {
            const Sample& before = samples_[i - 1];
            const double half = (s.time - before.time) / 2;
            so_far.input += half * (before.input_power + s.input_power);
            so_far.dissipated += half * (before.dissipated_power + s.dissipated_power);
        }
        if (i % stride != 0) continue;
        const double row[] = {s.time,    s.kinetic,    s.gravity,
                              s.elastic, so_far.input, so_far.dissipated};
        for (std::size_t c = 0; c < series.values.size(); ++c)
            series.values[c].push_back(row[c]);
    }
    results.series.push_back(std::move(series));
}

std::string energy_state(double residual, double accurate_within) {
    if (std::abs(residual) < accurate_within) return "ok";
    return residual < 0 ? "energy gain" : "inaccurate";
}

void EnergyBalance::finish(Results& results) {
    if (!applicable_ || samples_.size() < 3) return;
    const std::size_t last = samples_.size() - 1;
    const Balance balance = integrate(1, last);
    const double unit = scale(balance);
    if (unit > 0) {
        // Halving the sampling needs an even number of intervals.
        const std::size_t even = last - last % 2;
        const double coarsening = integrate(2, even).residual() - integrate(1, even).residual();
        results.measurements.push_back(
            {.observable = "energy_residual",
             .value = balance.residual() / unit,
             .systematic = std::abs(coarsening) / unit,
             .settings = {{"samples_per_contact_time", samples_per_contact_time_}}});
        if (options_.accurate_within) {
            const double residual = balance.residual() / unit;
            results.findings.push_back(
                {.name = "state",
                 .label = energy_state(residual, *options_.accurate_within),
                 .detail = fmt::format("energy residual {:+.3g} %", 100 * residual)});
        }
    }
    add_averages(results);
    add_series(results);
}

}  // namespace crossgrain::measure
