// The force between two discs in contact, Taguchi's Eq. (1) and its variants, as pure functions.
//   full vector:  F_i = k (d - r) n - eta v,               n = (x_i - x_j)/r,  v = v_i - v_j
//   normal only:  F_i = [k (d - r) - eta (v.n)] n
// Near the end of a contact the dashpot outweighs the spring and the normal force
// F_n = k (d - r) - eta (v.n) turns attractive. `AttractiveTail` says what happens then.
#pragma once

#include "native/dem/system.hpp"

namespace crossgrain::dem {

struct Force {
    double x = 0;
    double y = 0;
};

template <DampingDirection damping, AttractiveTail tail>
struct SpringDashpot {
    double stiffness;  ///< k
    double eta;        ///< dashpot coefficient on the relative velocity

    /// Force on i. `nx, ny` unit normal from j to i; `overlap` = d - r > 0; `vx, vy` = v_i - v_j.
    [[nodiscard]] Force operator()(double overlap, double nx, double ny, double vx,
                                   double vy) const {
        const double vn = vx * nx + vy * ny;
        double fn = stiffness * overlap - eta * vn;
        if constexpr (tail != AttractiveTail::kept) {
            if (fn < 0) {
                if constexpr (tail == AttractiveTail::contact_force_cut) return {};
                fn = 0;
            }
        }
        if constexpr (damping == DampingDirection::normal_only) {
            return {fn * nx, fn * ny};
        } else {
            return {fn * nx - eta * (vx - vn * nx), fn * ny - eta * (vy - vn * ny)};
        }
    }
};

}  // namespace crossgrain::dem
