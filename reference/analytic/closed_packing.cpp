#include "reference/analytic/closed_packing.hpp"

#include "reference/analytic/parameter_check.hpp"

#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace crossgrain::analytic {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

struct Bond {
    std::size_t i, j;
    double nx, ny;
};

double nearest(double separation, const std::optional<double>& period) {
    return period ? separation - *period * std::round(separation / *period) : separation;
}

std::vector<Bond> bonds_of(const ClosedPacking& p) {
    std::vector<Bond> bonds;
    for (std::size_t i = 0; i < p.x.size(); ++i) {
        for (std::size_t j = i + 1; j < p.x.size(); ++j) {
            const double dy = nearest(p.y[i] - p.y[j], p.period_y);
            if (std::abs(dy) >= p.diameter) continue;
            const double dx = nearest(p.x[i] - p.x[j], p.period_x);
            const double r = std::hypot(dx, dy);
            if (r < p.diameter && r > 0) bonds.push_back({i, j, dx / r, dy / r});
        }
    }
    return bonds;
}

bool is_on_plate(const ClosedPacking& p, std::size_t i) {
    return (p.bottom && p.y[i] < *p.bottom) || (p.lid && p.y[i] > *p.lid);
}

/// Numbers of the discs that touch something, in their order; -1 for the others.
std::vector<int> numbers_of(const ClosedPacking& p, const std::vector<Bond>& bonds) {
    std::vector<int> number(p.x.size(), -1);
    for (const Bond& bond : bonds)
        number[bond.i] = number[bond.j] = 0;
    int next = 0;
    for (std::size_t i = 0; i < number.size(); ++i)
        if (number[i] == 0 || is_on_plate(p, i)) number[i] = next++;
    return number;
}

/// Adds a bond between the discs numbered i and j with the symmetric 2 x 2 matrix (xx, xy, yy).
void add_bond(int i, int j, double xx, double xy, double yy, Triplets& elements) {
    for (const auto& [row, column, sign] :
         {std::tuple{i, i, 1.0}, {j, j, 1.0}, {i, j, -1.0}, {j, i, -1.0}}) {
        elements.emplace_back(2 * row, 2 * column, sign * xx);
        elements.emplace_back(2 * row, 2 * column + 1, sign * xy);
        elements.emplace_back(2 * row + 1, 2 * column, sign * xy);
        elements.emplace_back(2 * row + 1, 2 * column + 1, sign * yy);
    }
}

void check(const ClosedPacking& p) {
    require_positive("diameter", p.diameter);
    require_positive("mass", p.mass);
    require_positive("stiffness", p.stiffness);
    require_not_negative("damping", p.damping);
    require_not_negative("plate stiffness", p.plate_stiffness);
    if (p.x.size() != p.y.size()) throw std::invalid_argument("a packing needs an y for every x");
}

}  // namespace

PackingMatrices packing_matrices(const ClosedPacking& p) {
    check(p);
    const std::vector<Bond> bonds = bonds_of(p);
    const std::vector<int> number = numbers_of(p, bonds);
    const double k = p.stiffness / p.mass, eta = p.damping / p.mass;
    const bool full = p.damping_acts_on == Damping::full_vector;
    Triplets stiffness, damping;
    for (const auto& [i, j, nx, ny] : bonds) {
        add_bond(number[i], number[j], k * nx * nx, k * nx * ny, k * ny * ny, stiffness);
        if (full) {
            add_bond(number[i], number[j], eta, 0, eta, damping);
        } else {
            add_bond(number[i], number[j], eta * nx * nx, eta * nx * ny, eta * ny * ny, damping);
        }
    }
    int discs = 0;
    for (std::size_t i = 0; i < number.size(); ++i) {
        if (number[i] < 0) continue;
        ++discs;
        if (is_on_plate(p, i)) {
            const int row = 2 * number[i] + 1;
            stiffness.emplace_back(row, row, p.plate_stiffness / p.mass);
        }
    }
    PackingMatrices matrices{Eigen::SparseMatrix<double>(2 * discs, 2 * discs),
                             Eigen::SparseMatrix<double>(2 * discs, 2 * discs)};
    matrices.stiffness.setFromTriplets(stiffness.begin(), stiffness.end());
    matrices.damping.setFromTriplets(damping.begin(), damping.end());
    return matrices;
}

}  // namespace crossgrain::analytic
