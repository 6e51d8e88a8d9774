// Stiffness and damping matrices of a packing of discs at rest, near equilibrium.
//
// With the displacements u of all discs the linear equation of motion is u'' = -K u - C u'. A
// contact with the unit normal n between discs i and j adds to the block (i, i) and takes from
// (i, j), and the same for j,
//   K: (k/m) n n^T      C: (eta/m) n n^T  (normal only)  or  (eta/m) 1  (full vector),
// an elastic plate that a disc's centre has passed adds k_plate/m to the disc's yy element of K.
// The forces within the overlaps (their turning with the bond) are neglected: a relative error of
// the order of overlap/diameter.
#pragma once

#include "reference/analytic/oblique_collision.hpp"

#include <Eigen/SparseCore>

#include <optional>
#include <vector>

namespace crossgrain::analytic {

struct ClosedPacking {
    std::vector<double> x, y;                  ///< shape (grains)
    std::optional<double> period_x, period_y;  ///< open where absent
    double diameter = 0, mass = 0, stiffness = 0, damping = 0;
    Damping damping_acts_on = Damping::full_vector;
    double plate_stiffness = 0;         ///< elastic plates that touch centres
    std::optional<double> bottom, lid;  ///< heights
};

/// Both symmetric, shape (2 grains, 2 grains): x and y of each.
struct PackingMatrices {
    Eigen::SparseMatrix<double> stiffness;  ///< K (1/t^2)
    Eigen::SparseMatrix<double> damping;    ///< C (1/t)
};

/// Of the discs that touch something; the others move freely and are left out. Throws
/// std::domain_error for a diameter, mass or stiffness that is not positive, a negative damping or
/// plate stiffness, and std::invalid_argument for x and y of different length.
[[nodiscard]] PackingMatrices packing_matrices(const ClosedPacking& packing);

}  // namespace crossgrain::analytic
