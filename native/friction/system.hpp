// Parameters and state of a two-dimensional system of rotating discs of different sizes with
// friction between them. Reduced units: the equations hold for any consistent set.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace crossgrain::friction {

/// `none`: smooth discs, which do not turn. `dashpot`: F_t = -gamma_t v_t, `spring`: with a spring
/// that remembers the contact, F_t = -k_t s - gamma_t v_t; both cut at mu |F_n|.
enum class TangentialForce { none, dashpot, spring };

/// The arm from a grain's centre to the contact: its radius r, or r - overlap/2.
enum class Lever { radius, contact_point };

/// How the spring follows the turning of the normal in a step: projected onto the new tangent;
/// projected and rescaled to its old length; or s -= s x (n_old x n_new).
enum class SpringRotation { project, project_and_rescale, rotate };

/// What is cut at mu |F_n|: spring and dashpot together, or the spring, the dashpot being added
/// only while it is not cut.
enum class CoulombLimit { total, spring_only };

/// What codes do differently; each combination is compiled on its own.
struct Conventions {
    Lever velocity_lever = Lever::contact_point;
    Lever torque_lever = Lever::contact_point;
    SpringRotation rotation = SpringRotation::project;
    CoulombLimit limit = CoulombLimit::spring_only;
    friend bool operator==(const Conventions&, const Conventions&) = default;
};

/// Whether dashpots are as strong as they say or per unit of m_i m_j/(m_i + m_j), frozen grains
/// counting as infinitely heavy.
enum class DampingScale { absolute, effective_mass };

/// Whether the dashpot may pull at the end of a contact. Without pull there is no friction there
/// either, the limit being mu |F_n|.
enum class AttractiveTail { kept, cut };

struct ContactParameters {
    double stiffness = 0;  ///< k_n (m/t^2), > 0
    double damping = 0;    ///< eta_n (m/t), or per unit of effective mass (1/t), >= 0
    DampingScale damping_scale = DampingScale::absolute;
    AttractiveTail tail = AttractiveTail::kept;
    TangentialForce tangential = TangentialForce::spring;
    double friction = 0;              ///< mu, >= 0
    double tangential_stiffness = 0;  ///< k_t (m/t^2), > 0 with a spring
    double tangential_damping = 0;    ///< gamma_t, scaled as eta_n, >= 0
    Conventions conventions;
};

/// Elastic vertical planes that push the centres of grains behind them back.
struct BackingPlanes {
    double stiffness = 0;        ///< (m/t^2)
    double left = 0, right = 0;  ///< along x, left < right
};

/// Which kernel computes the steps. The scalar one rounds identically on every machine;
/// `automatic` takes the simd kernel where there are vectors and enough grains.
enum class Kernel { automatic, scalar, simd };

struct Parameters {
    ContactParameters contact;
    double inertia_factor = 0.5;               ///< I = inertia_factor m r^2, > 0
    double gravity = 0;                        ///< along -y
    double drag = 0;                           ///< force -drag v (m/t)
    std::optional<BackingPlanes> backing;      ///< act on mobile grains
    std::optional<double> period_x, period_y;  ///< open where absent
    double dt = 0;                             ///< > 0
    Kernel kernel = Kernel::automatic;
};

/// Shape of all arrays: (grains). Positions are unwrapped.
struct State {
    std::int64_t step = 0;
    std::vector<double> x, y, vx, vy;
    std::vector<double> omega;         ///< counter-clockwise (1/t)
    std::vector<double> radius, mass;  ///< > 0
    std::vector<std::size_t> frozen;   ///< indices of grains that never move nor turn
};

}  // namespace crossgrain::friction
