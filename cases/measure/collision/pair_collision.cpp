#include "cases/measure/collision/pair_collision.hpp"

#include "native/numerics/mean_with_error.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace crossgrain::measure {
namespace {

constexpr double head_on = 1e-6;  // |b|/d below which angular momentum is round-off

bool has_plates(const scene::Plates& plates) {
    return plates.bottom || !std::holds_alternative<std::monostate>(plates.lid);
}

// Time until a point at distance `normal` from the foot of its path, moving towards it, meets the
// circle of radius d; nothing if the path passes by or the point moves away or is inside already.
std::optional<double> time_to_circle(double x, double y, double vx, double vy, double d) {
    const double speed_squared = vx * vx + vy * vy;
    const double along = x * vx + y * vy;
    const double cross = x * vy - y * vx;
    const double excess = x * x + y * y - d * d;
    const double reach = speed_squared * d * d - cross * cross;  // (half the chord)^2 v^2
    if (excess < 0 || along >= 0 || reach <= 0) return std::nullopt;
    // The smaller root of |r + v t|^2 = d^2 without cancellation.
    return excess / (-along + std::sqrt(reach));
}

}  // namespace

PairCollision::PairCollision(const scene::Scene& scene)
    : applicable_(scene.gravity == 0 && !has_plates(scene.plates) && scene.grain_count() > 0 &&
                  scene.grain_count() % 2 == 0),
      pairs_(scene.grain_count() / 2), period_x_(scene.periodic_x), period_y_(scene.periodic_y) {
    for (std::size_t k = 0; k < pairs_; ++k) {
        reach_.push_back((scene.grains.diameter_of(2 * k) + scene.grains.diameter_of(2 * k + 1)) /
                         2);
    }
}

void PairCollision::choose_images(const scene::Frame& frame) {
    for (std::size_t k = 0; k < pairs_; ++k) {
        const double x = frame.x[2 * k + 1] - frame.x[2 * k];
        const double y = frame.y[2 * k + 1] - frame.y[2 * k];
        shift_x_.push_back(scene::nearest_image(x, period_x_) - x);
        shift_y_.push_back(scene::nearest_image(y, period_y_) - y);
    }
}

std::vector<PairCollision::Flight> PairCollision::flights(const scene::Frame& frame) const {
    std::vector<Flight> result(pairs_);
    for (std::size_t k = 0; k < pairs_; ++k) {
        const std::size_t i = 2 * k, j = i + 1;
        result[k] = {frame.time, frame.x[j] - frame.x[i] + shift_x_[k],
                     frame.y[j] - frame.y[i] + shift_y_[k], frame.vx[j] - frame.vx[i],
                     frame.vy[j] - frame.vy[i]};
    }
    return result;
}

void PairCollision::add(const scene::Frame& frame) {
    if (!applicable_) return;
    if (first_.empty()) {
        choose_images(frame);
        first_ = flights(frame);
    } else {
        last_ = flights(frame);
    }
}

std::optional<PairCollision::Collision> PairCollision::collision(const Flight& first,
                                                                 const Flight& last, double d) {
    const auto until = time_to_circle(first.x, first.y, first.vx, first.vy, d);
    // Backwards in time the outgoing flight is an incoming one.
    const auto since = time_to_circle(last.x, last.y, -last.vx, -last.vy, d);
    if (!until || !since) return std::nullopt;

    const double in_x = first.x + first.vx * *until, in_y = first.y + first.vy * *until;
    const double out_x = last.x - last.vx * *since, out_y = last.y - last.vy * *since;
    const double time = (last.time - *since) - (first.time + *until);
    const double speed_in = std::hypot(first.vx, first.vy);
    const double speed_out = std::hypot(last.vx, last.vy);
    const double change = std::hypot(last.vx - first.vx, last.vy - first.vy);
    const bool interacted = change > 1e-9 * speed_in;
    const bool passed_through = in_x * out_x + in_y * out_y < 0;
    if (time <= 0 || !interacted || passed_through) return std::nullopt;

    const double normal_in = (first.vx * in_x + first.vy * in_y) / d;
    const double normal_out = (last.vx * out_x + last.vy * out_y) / d;
    const double cross_in = first.x * first.vy - first.y * first.vx;
    const double cross_out = last.x * last.vy - last.y * last.vx;
    return Collision{.restitution = -normal_out / normal_in,
                     .contact_time = time,
                     .angular_momentum_ratio = cross_in == 0 ? 0.0 : cross_out / cross_in,
                     .speed_ratio = speed_out / speed_in,
                     .impact_parameter = std::abs(cross_in) / (speed_in * d),
                     .approach_speed = speed_in};
}

void PairCollision::finish(Results& results) {
    if (!applicable_ || first_.empty()) return;
    std::vector<Collision> complete;
    for (std::size_t k = 0; k < last_.size(); ++k) {
        if (const auto found = collision(first_[k], last_[k], reach_[k]))
            complete.push_back(*found);
    }
    results.measurements.push_back({.observable = "complete_collisions",
                                    .value = static_cast<double>(complete.size()),
                                    .n = pairs_,
                                    .settings = {}});
    if (complete.size() != pairs_) return;

    add_complete(complete, results);
}

void PairCollision::add_complete(const std::vector<Collision>& complete, Results& results) {
    Series series{.name = "collisions", .columns = {"pair"}, .values = {{}}};
    for (std::size_t k = 0; k < complete.size(); ++k)
        series.values[0].push_back(static_cast<double>(k));
    const auto add_column = [&](const std::string& name, double Collision::*quantity) {
        series.columns.push_back(name);
        auto& column = series.values.emplace_back();
        for (const Collision& one : complete)
            column.push_back(one.*quantity);
    };
    const auto add_both = [&](const std::string& name, double Collision::*quantity,
                              const std::string& unit) {
        add_column(name, quantity);
        const numerics::MeanWithError mean = numerics::mean_with_error(series.values.back());
        results.measurements.push_back({.observable = name,
                                        .value = mean.value,
                                        .standard_error = mean.standard_error,
                                        .n = mean.n,
                                        .unit = unit,
                                        .settings = {}});
    };
    add_both("restitution", &Collision::restitution, "1");
    add_both("contact_time", &Collision::contact_time, "t");
    const bool all_oblique = std::ranges::all_of(
        complete, [](const Collision& one) { return one.impact_parameter >= head_on; });
    if (all_oblique) add_both("angular_momentum_ratio", &Collision::angular_momentum_ratio, "1");
    add_both("speed_ratio", &Collision::speed_ratio, "1");
    add_column("impact_parameter", &Collision::impact_parameter);
    add_column("approach_speed", &Collision::approach_speed);
    results.series.push_back(std::move(series));
}

}  // namespace crossgrain::measure
