// The force between two rotating discs in contact: linear spring-dashpot along the normal n (from j
// to i), Coulomb-limited spring and dashpot along the tangent t = (-n_y, n_x).
//   F_n = k_n delta - eta_n (v.n)                       v = v_i - v_j
//   v_t = v.t - (l_i omega_i + l_j omega_j)             velocity lever l
//   F_t = -k_t s - gamma_t v_t,  ds/dt = v_t,  |F_t| <= mu |F_n|
//   torque on i: -l_i F_t, on j: -l_j F_t               torque lever l
// (Cundall & Strack, Geotechnique 29, 47 (1979); Luding, Granular Matter 10, 235 (2008), Eqs. 2-17;
// Silbert et al., PRE 64, 051302 (2001), Eqs. 1-5.) The spring is kept as a vector, which lies in
// the last step's tangent.
#pragma once

#include "native/friction/system.hpp"

#include <algorithm>
#include <cmath>

namespace crossgrain::friction {

/// Two overlapping discs as the force sees them.
struct Touch {
    double overlap = 0;  ///< delta > 0
    double nx = 0, ny = 0;
    double vx = 0, vy = 0;  ///< v_i - v_j
    double radius_i = 0, radius_j = 0;
    double omega_i = 0, omega_j = 0;
    double damping = 0;             ///< eta_n of this pair (m/t)
    double tangential_damping = 0;  ///< gamma_t of this pair (m/t)
};

/// The spring s and the normal of the step before; all zero when a contact closes.
struct ContactMemory {
    double x = 0, y = 0;
    double nx = 0, ny = 0;
};

/// On i; j gets the opposite force.
struct ContactForce {
    double x = 0, y = 0;
    double torque_i = 0, torque_j = 0;
};

/// Unlike std::hypot, rounded alike on every machine.
[[nodiscard]] inline double length_of(double x, double y) {
    return std::sqrt(x * x + y * y);
}

template <Lever lever>
[[nodiscard]] double arm(double radius, double overlap) {
    return lever == Lever::radius ? radius : radius - 0.5 * overlap;
}

/// The spring after the normal has turned from that of the memory to the new one.
template <SpringRotation rotation>
void follow(ContactMemory& s, double nx, double ny) {
    if constexpr (rotation == SpringRotation::rotate) {
        const double turn = s.nx * ny - s.ny * nx;
        const double x = s.x;
        s.x -= s.y * turn;
        s.y += x * turn;
    } else {
        const double length = length_of(s.x, s.y);
        const double along = s.x * nx + s.y * ny;
        s.x -= along * nx;
        s.y -= along * ny;
        if constexpr (rotation == SpringRotation::project_and_rescale) {
            const double projected = length_of(s.x, s.y);
            const double factor = projected > 0 ? length / projected : 0;
            s.x *= factor;
            s.y *= factor;
        }
    }
}

template <TangentialForce tangential, Conventions conventions>
class FrictionLaw {
  public:
    explicit FrictionLaw(const ContactParameters& p) : p_(p) {}

    /// `dt` = 0 leaves the spring as long as it is.
    [[nodiscard]] ContactForce operator()(const Touch& c, double dt, ContactMemory& memory) const {
        double fn = p_.stiffness * c.overlap - c.damping * (c.vx * c.nx + c.vy * c.ny);
        if (p_.tail == AttractiveTail::cut && fn < 0) fn = 0;
        ContactForce f{.x = fn * c.nx, .y = fn * c.ny};
        if constexpr (tangential == TangentialForce::none) return f;
        const double li = arm<conventions.velocity_lever>(c.radius_i, c.overlap);
        const double lj = arm<conventions.velocity_lever>(c.radius_j, c.overlap);
        const double vt = c.vy * c.nx - c.vx * c.ny - (li * c.omega_i + lj * c.omega_j);
        const double limit = p_.friction * std::abs(fn);
        double fx = 0, fy = 0;
        if constexpr (tangential == TangentialForce::dashpot) {
            const double ft =
                -std::copysign(std::min(limit, c.tangential_damping * std::abs(vt)), vt);
            fx = -ft * c.ny;
            fy = ft * c.nx;
        } else {
            follow<conventions.rotation>(memory, c.nx, c.ny);
            const double vtx = -vt * c.ny, vty = vt * c.nx;
            memory.x += vtx * dt;
            memory.y += vty * dt;
            memory.nx = c.nx;
            memory.ny = c.ny;
            fx = -p_.tangential_stiffness * memory.x;
            fy = -p_.tangential_stiffness * memory.y;
            add_dashpot_and_cut(c.tangential_damping * vtx, c.tangential_damping * vty, limit, fx,
                                fy, memory);
        }
        f.x += fx;
        f.y += fy;
        const double ft = fy * c.nx - fx * c.ny;
        f.torque_i = -arm<conventions.torque_lever>(c.radius_i, c.overlap) * ft;
        f.torque_j = -arm<conventions.torque_lever>(c.radius_j, c.overlap) * ft;
        return f;
    }

  private:
    /// From the spring's force to the whole one; a spring that slides is shortened.
    void add_dashpot_and_cut(double dashpot_x, double dashpot_y, double limit, double& fx,
                             double& fy, ContactMemory& memory) const {
        constexpr bool cut_together = conventions.limit == CoulombLimit::total;
        if constexpr (cut_together) {
            fx -= dashpot_x;
            fy -= dashpot_y;
        }
        const double magnitude = length_of(fx, fy);
        if (magnitude > limit) {
            fx *= limit / magnitude;
            fy *= limit / magnitude;
            memory.x = -(fx + (cut_together ? dashpot_x : 0)) / p_.tangential_stiffness;
            memory.y = -(fy + (cut_together ? dashpot_y : 0)) / p_.tangential_stiffness;
        } else if (!cut_together) {
            fx -= dashpot_x;
            fy -= dashpot_y;
        }
    }

    ContactParameters p_;
};

}  // namespace crossgrain::friction
