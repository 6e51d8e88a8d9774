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

/// How a time step is made; each is documented where it stands, in native/dem/scheme_*.hpp.
/// `taguchi_euler` is the paper's scheme (Eqs. 7 and 8) at fixed dt; `taguchi_adaptive_euler` its
/// adaptive form (Eqs. 9 and 10), with sub-steps that end exactly at multiples of dt and are never
/// longer than it.
enum class Scheme {
    verlet_half_step,
    verlet_predicted,
    leapfrog_crank_nicolson,
    semi_implicit_euler,
    explicit_euler,
    runge_kutta_4,
    taguchi_euler,
    taguchi_adaptive_euler
};

/// Which grains can touch: all that come near, or only those that are nearer than
/// Parameters::lattice_cutoff at the start (Taguchi, section 3: six fixed neighbours). Contacts
/// open and close by the step function in either case.
enum class Contacts { neighbour_list, lattice_neighbours };

/// `mixed`: positions are 32-bit integers, velocities and forces floats (simd kernel only).
enum class Precision { double_precision, mixed };

/// What computes the step. `automatic` is the simd kernel for verlet_predicted where it has what
/// the system needs and the system is large enough, the scalar one otherwise
/// (native/dem/kernel_choice.cpp). The scalar one rounds identically on every machine.
enum class Kernel { automatic, scalar, simd };

/// Plate at y(t) = height + amplitude cos(omega t + phase).
struct MovingPlate {
    double height = 0;
    double amplitude = 0;
    double omega = 0;  ///< angular frequency (1/t)
    double phase = 0;  ///< angle at t = 0
    [[nodiscard]] double position(double t) const {
        return height + amplitude * std::cos(omega * t + phase);
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
    double dt = 0;  ///< > 0; of taguchi_adaptive_euler the longest sub-step
    Contacts contacts = Contacts::neighbour_list;
    /// Distance up to which grains are fixed neighbours; 0 stands for 1.366 d, halfway between the
    /// first and the second shell of a triangular lattice of spacing d.
    double lattice_cutoff = 0;
    Precision precision = Precision::double_precision;
    Kernel kernel = Kernel::automatic;
    int threads = 1;  ///< of the simd kernel, >= 1; results do not depend on it
    double skin = 0;  ///< of the neighbour list (length); 0 leaves it to the kernel
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
