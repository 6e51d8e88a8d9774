// Oblique collision of two discs without spin, by high-order integration of the relative motion.
//
// Relative position r, velocity v = dr/dt, n = r/|r|, overlap delta = d - |r|, v_n = v . n,
// v_t = v - v_n n (reduced units):
//   mu dv/dt = (k delta - eta v_n) n - eta v_t   full vector (Taguchi, chao-dyn/9405003 (1994),
//                                                Eq. 1)
//   mu dv/dt = (k delta - eta v_n) n             normal only
// Where the normal force k delta - eta v_n turns attractive, Clipping::none keeps it, ::all drops
// the whole force, ::normal_only drops the normal force and keeps -eta v_t. Once dropped it stays
// so: from there on the grains part ever faster along n. The contact ends at |r| = d.
//
// There is no closed form because the normal turns. Exact statements that remain: the angular
// momentum ratio exp(-eta t_c/mu) for full vector damping without clipping, 1 for normal-only
// damping; the head-on limit (normal_collision.hpp).
//
// Method: Runge-Kutta-Fehlberg 7(8) with step control at relative and absolute tolerance 1e-13
// (Boost.Odeint); the motion is integrated phase by phase, so that the right-hand side is smooth
// within each, and the end of a phase is found by root finding on the length of the last step.
#pragma once

namespace crossgrain::analytic {

enum class Damping { full_vector, normal_only };
enum class Clipping { none, all, normal_only };

struct ObliqueContact {
    double stiffness = 0;     ///< k (m/t^2), > 0
    double damping = 0;       ///< eta (m/t), >= 0
    double reduced_mass = 0;  ///< mu (m), > 0
    double diameter = 0;      ///< d (l), > 0
    Damping damping_acts_on = Damping::full_vector;
    Clipping clipping = Clipping::none;
};

struct ObliqueImpact {
    double speed = 0;             ///< |v| before the contact (l/t), > 0
    double impact_parameter = 0;  ///< b (l), 0 <= b < d
};

struct ObliqueCollision {
    double restitution = 0;             ///< e = -(v_out . n_out)/(v_in . n_in)
    double contact_time = 0;            ///< (t), from |r| = d to |r| = d
    double force_time = 0;              ///< (t), until the normal force is dropped; else t_c
    double angular_momentum_ratio = 0;  ///< (r x v)_out/(r x v)_in; its limit if b = 0 is not
                                        ///< taken: NaN
    double speed_ratio = 0;             ///< |v_out|/|v_in|
    double deflection = 0;              ///< angle from v_in to v_out (rad), in [0, pi]
    double dissipated = 0;  ///< loss of kinetic energy of the relative motion (m l^2/t^2)
};

/// Throws std::domain_error for parameters out of range, for a speed at which the centres could
/// meet (v sqrt(mu/k) >= d), and if the grains do not part within 100 undamped half periods pi
/// sqrt(mu/k) (they stick: overdamped without clipping).
[[nodiscard]] ObliqueCollision oblique_collision(const ObliqueContact& contact,
                                                 const ObliqueImpact& impact);

}  // namespace crossgrain::analytic
