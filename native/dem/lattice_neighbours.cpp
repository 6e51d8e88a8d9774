#include "native/dem/lattice_neighbours.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace crossgrain::dem {
namespace {

/// (1 + sqrt(3))/2 diameters, halfway between the first and the second shell.
constexpr double default_cutoff_in_diameters = 1.3660254037844386;

double cutoff(const Parameters& p) {
    if (p.lattice_cutoff == 0) return default_cutoff_in_diameters * p.diameter;
    if (!(p.lattice_cutoff >= p.diameter)) {
        throw std::invalid_argument(fmt::format("lattice_cutoff is {:g}, expected at least the "
                                                "diameter {:g}: grains touch at that distance",
                                                p.lattice_cutoff, p.diameter));
    }
    return p.lattice_cutoff;
}

}  // namespace

LatticeNeighbours::LatticeNeighbours(const Parameters& parameters, std::span<const double> x,
                                     std::span<const double> y)
    : diameter_(parameters.diameter),
      all_(parameters.diameter, parameters.diameter / 2, parameters.period_x, parameters.period_y) {
    NeighbourList near(cutoff(parameters), 0.0, parameters.period_x, parameters.period_y);
    near.update(x, y);
    pairs_ = near.pairs();
    for (const Pair& pair : pairs_)
        fixed_.emplace(pair.i, pair.j);
}

void LatticeNeighbours::watch(std::span<const double> x, std::span<const double> y, double time) {
    all_.update(x, y);
    if (all_.builds() != builds_) {
        builds_ = all_.builds();
        strangers_.clear();
        for (const Pair& pair : all_.pairs()) {
            if (!fixed_.contains({pair.i, pair.j})) strangers_.push_back(pair);
        }
    }
    for (const Pair& pair : strangers_) {
        const double dx = x[pair.i] - x[pair.j] + pair.shift_x;
        const double dy = y[pair.i] - y[pair.j] + pair.shift_y;
        if (dx * dx + dy * dy >= diameter_ * diameter_) continue;
        overlapped_.emplace(pair.i, pair.j);
        if (!first_time_) first_time_ = time;
    }
}

MissedContacts LatticeNeighbours::missed() const {
    return {.pairs = static_cast<std::int64_t>(overlapped_.size()), .first_time = first_time_};
}

}  // namespace crossgrain::dem
