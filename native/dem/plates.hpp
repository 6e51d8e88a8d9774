// Elastic plates without dissipation (Taguchi, section 2.2 and Eq. 2): a grain whose touching
// point lies beyond the plate by `overlap` is pushed back with k overlap, the lid with the
// reaction.
#pragma once

#include "native/dem/system.hpp"

#include <cstddef>
#include <span>

namespace crossgrain::dem {

/// Adds the bottom's force to fy. shape (grains)
inline void push_from_bottom(double bottom, double stiffness, double reach,
                             std::span<const double> y, std::span<double> fy) {
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double overlap = bottom - (y[i] - reach);
        if (overlap > 0) fy[i] += stiffness * overlap;
    }
}

/// Adds the lid's force to fy and returns the sum of the reactions on the lid.
inline double push_from_lid(double lid, double stiffness, double reach, std::span<const double> y,
                            std::span<double> fy) {
    double reaction = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double overlap = (y[i] + reach) - lid;
        if (overlap > 0) {
            fy[i] -= stiffness * overlap;
            reaction += stiffness * overlap;
        }
    }
    return reaction;
}

}  // namespace crossgrain::dem
