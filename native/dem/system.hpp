// Parameters and state of a two-dimensional system of equal discs between horizontal plates
// (Taguchi, "Numerical study of granular turbulence ...", Eqs. 1 and 2). Reduced units: the
// equations hold for any consistent set; the paper's has grain mass 1, gravity 1, diameter 2.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace crossgrain::dem {

enum class DampingDirection { full_vector, normal_only };
enum class AttractiveTail { kept, contact_force_cut, normal_force_cut };
enum class Scheme { verlet_half_step, verlet_predicted };

/// Plate at y(t) = height + amplitude cos(omega t).
struct MovingPlate {
    double height = 0;
    double amplitude = 0;
    double omega = 0;  ///< angular frequency (1/t)
    [[nodiscard]] double position(double t) const {
        return height + amplitude * std::cos(omega * t);
    }
};

/// Lid of finite mass that moves freely under gravity and the grains' push.
struct InertialLid {
    double mass = 0;
};

using Lid = std::variant<std::monostate, MovingPlate, InertialLid>;

struct Parameters {
    double diameter = 0;   ///< d
    double mass = 0;       ///< m
    double stiffness = 0;  ///< k (m/t^2)
    double damping = 0;    ///< eta (m/t), on the relative velocity
    DampingDirection damping_direction = DampingDirection::full_vector;
    AttractiveTail tail = AttractiveTail::kept;
    double gravity = 0;                        ///< along -y
    std::optional<double> period_x, period_y;  ///< open where absent
    double plate_stiffness = 0;                ///< elastic, no dissipation
    double plate_reach = 0;  ///< 0: plates touch centres; d/2: they touch surfaces
    std::optional<MovingPlate> bottom;
    Lid lid;
    Scheme scheme = Scheme::verlet_half_step;
    double dt = 0;
};

/// Shape of all arrays: (grains). Positions are unwrapped.
struct State {
    std::int64_t step = 0;
    std::vector<double> x, y, vx, vy;
    std::vector<std::size_t>
        frozen;             ///< indices of grains that never move, whatever their velocity
    double lid_height = 0;  ///< used with an InertialLid only
    double lid_velocity = 0;
};

}  // namespace crossgrain::dem
