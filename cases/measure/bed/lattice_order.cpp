#include "cases/measure/bed/lattice_order.hpp"

namespace crossgrain::measure {
namespace {

constexpr double halfway_to_second_shell = 1.366;  // (1 + sqrt 3)/2

}  // namespace

LatticeOrder::LatticeOrder(const scene::Scene& scene)
    : contacts_(scene.grains.diameter, scene.periodic_x, scene.periodic_y),
      neighbours_(halfway_to_second_shell * scene.grains.diameter, scene.periodic_x,
                  scene.periodic_y) {}

void LatticeOrder::add(const scene::Frame& frame) {
    if (!started_) {
        for (const scene::Contact& c : neighbours_.find(frame.x, frame.y))
            lattice_pairs_.emplace(c.i, c.j);
        started_ = true;
    }
    for (const scene::Contact& c : contacts_.find(frame.x, frame.y)) {
        if (!lattice_pairs_.contains({c.i, c.j})) foreign_pairs_.emplace(c.i, c.j);
    }
    if (foreign_pairs_.empty()) kept_until_ = frame.time;
}

void LatticeOrder::finish(Results& results) {
    if (!started_) return;
    results.measurements.push_back({.observable = "foreign_contacts",
                                    .value = static_cast<double>(foreign_pairs_.size()),
                                    .settings = {}});
    results.measurements.push_back(
        {.observable = "lattice_kept_until", .value = kept_until_, .unit = "t", .settings = {}});
}

}  // namespace crossgrain::measure
