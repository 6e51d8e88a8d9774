#include "cases/measure/discharge/discharge_stagnation.hpp"

#include "native/base/memory_budget.hpp"
#include "native/numerics/jackknife.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace crossgrain::measure {
namespace {

constexpr double wall_reach = 1.5, centre_reach = 2;  // diameters
constexpr double fewest_grains = 16;

void check(const DischargeStagnationOptions& o) {
    check_ranges(o);
    if (!(o.to > o.from)) {
        throw std::invalid_argument(fmt::format("needs from < to, not {} and {}", o.from, o.to));
    }
}

}  // namespace

DischargeStagnation::DischargeStagnation(const scene::Scene& scene,
                                         DischargeStagnationOptions options)
    : walls_(hopper_walls(scene)), options_(std::move(options)),
      bin_(options_.bin * walls_.diameter),
      interval_(scene.dt * static_cast<double>(scene.frame_every)) {
    check(options_);
    const double bins = std::ceil(walls_.height / bin_);
    require_memory(bins * sizeof(bins_[0]), "bins along the walls");
    bins_.resize(static_cast<std::size_t>(bins));
}

void DischargeStagnation::add(const scene::Frame& frame) {
    last_time_ = frame.time;
    if (frame.time < options_.from || frame.time > options_.to) return;
    const double passed = (frame.time - options_.from) / (options_.to - options_.from);
    const auto quarter =
        std::min(quarters_ - 1, static_cast<std::size_t>(passed * static_cast<double>(quarters_)));
    const double along = std::hypot(1.0, walls_.tangent);
    for (const std::size_t i : walls_.mobile) {
        const double above = frame.y[i] - walls_.level, x = frame.x[i] - walls_.axis;
        const auto at = static_cast<std::size_t>(std::max(0.0, above) / bin_);
        if (above < 0 || at >= bins_.size()) continue;
        if (std::abs(x) <= centre_reach * walls_.diameter) {
            Sum& centre = bins_[at].centre[quarter];
            centre.n += 1;
            centre.velocity -= frame.vy[i];
        }
        if (walls_.from_wall(frame.x[i], frame.y[i]) > wall_reach * walls_.diameter) continue;
        Sum& wall = bins_[at].wall[quarter + (x > 0 ? quarters_ : 0)];
        const double inward = x > 0 ? -frame.vx[i] : frame.vx[i];
        wall.n += 1;
        wall.velocity += (inward * walls_.tangent - frame.vy[i]) / along;
    }
}

std::vector<DischargeStagnation::Row> DischargeStagnation::profile(std::size_t left_out) const {
    std::vector<Row> rows;
    for (std::size_t b = 0; b < bins_.size(); ++b) {
        Sum wall, centre;
        for (std::size_t p = 0; p < parts_; ++p) {
            if (p == left_out) continue;
            wall.n += bins_[b].wall[p].n;
            wall.velocity += bins_[b].wall[p].velocity;
        }
        for (const Sum& part : bins_[b].centre) {
            centre.n += part.n;
            centre.velocity += part.velocity;
        }
        if (wall.n < fewest_grains || centre.n < fewest_grains || !(centre.velocity > 0)) break;
        rows.push_back({.height = (static_cast<double>(b) + 0.5) * bin_ / walls_.height,
                        .wall = wall.velocity / wall.n,
                        .centre = centre.velocity / centre.n});
    }
    return rows;
}

double DischargeStagnation::moving_fraction(const std::vector<Row>& profile, double share) const {
    double height = 0, ratio = 1;  // all grains move at the outlet
    for (const Row& row : profile) {
        if (row.ratio() < share) {
            const double part = (ratio - share) / (ratio - row.ratio());
            return std::min(1.0, height + part * (row.height - height));
        }
        height = row.height;
        ratio = row.ratio();
    }
    return 1;
}

void DischargeStagnation::finish(Results& results) {
    if (last_time_ < options_.to - interval_) return;
    const std::vector<Row> whole = profile(parts_);
    if (whole.size() < 2) return;
    bool mass_flow = true;
    for (const double share : options_.shares) {
        std::vector<double> without;
        for (std::size_t p = 0; p < parts_; ++p)
            without.push_back(moving_fraction(profile(p), share));
        const double moving = moving_fraction(whole, share);
        mass_flow = mass_flow && moving == 1;
        results.measurements.push_back(
            {.observable = fmt::format("moving_fraction_{:g}", share),
             .value = moving,
             .standard_error = numerics::jackknife_error(without),
             .n = parts_,
             .settings = {{"eps", share},
                          {"from", options_.from},
                          {"to", options_.to},
                          {"half_angle", std::atan(walls_.tangent) * 180 / std::numbers::pi}}});
    }
    Series series{.name = "wall-profile",
                  .columns = {"height", "ratio", "wall", "centre"},
                  .values = std::vector<std::vector<double>>(4),
                  .units = {"1", "1", "l/t", "l/t"}};
    for (const Row& row : whole) {
        series.values[0].push_back(row.height);
        series.values[1].push_back(row.ratio());
        series.values[2].push_back(row.wall);
        series.values[3].push_back(row.centre);
    }
    results.series.push_back(std::move(series));
    results.findings.push_back(
        {.name = "state",
         .label = mass_flow ? "mass flow" : "funnel flow",
         .detail = mass_flow ? "grains at the walls keep up with the centre line all the way"
                             : "grains at the walls fall behind the centre line"});
}

}  // namespace crossgrain::measure
