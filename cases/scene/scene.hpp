// The code-neutral description of one run: what every granular code, native or foreign, must decide
// before it can start, and nothing else. Reduced units throughout: lengths, masses and times are
// those of Taguchi's paper (grain mass m = 1, gravity g = 1, diameter d = 2).
#pragma once

#include "cases/scene/friction.hpp"
#include "native/base/enum_words.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace crossgrain::scene {

using crossgrain::to_string;

/// Which part of the relative velocity the dashpot acts on.
/// `full_vector` is Taguchi's Eq. (1); `normal_only` is the default of many other codes.
enum class Damping { full_vector, normal_only };
constexpr auto words(Damping /*of*/) {
    return std::array{"full-vector", "normal-only"};
}

/// What happens when the total normal force (spring + dashpot) becomes attractive at the end of a
/// contact: `none` keeps the attraction (Taguchi, Eq. 1), `all` cuts the whole contact force,
/// `normal_only` cuts the normal force and keeps the tangential dashpot.
enum class Clipping { none, all, normal_only };
constexpr auto words(Clipping /*of*/) {
    return std::array{"none", "all", "normal-only"};
}

/// Whether grains rotate. With `on` the tangential dashpot acts at the point of contact.
enum class Spins { off, on };
constexpr auto words(Spins /*of*/) {
    return std::array{"off", "on"};
}

/// What a horizontal plate touches: the grain's centre (Taguchi, Eqs. 2 and 14) or its surface.
enum class PlateContact { centre, surface };
constexpr auto words(PlateContact /*of*/) {
    return std::array{"centre", "surface"};
}

/// `verlet_half_step`: kick dt/2, drift dt, force from (x_{n+1}, v_{n+1/2}), kick dt/2. This is
/// what LAMMPS and LIGGGHTS do, and it is YADE's leap-frog seen half a step apart.
/// `verlet_predicted`: the same with v_{n+1/2} + a_n dt/2 in the dashpot (second order).
/// `leapfrog_crank_nicolson`: leap-frog with the mean of the old and new half-step velocities in
/// the dashpot.
/// `semi_implicit_euler`: v_{n+1} = v_n + a(x_n, v_n) dt, x_{n+1} = x_n + v_{n+1} dt.
/// `explicit_euler`: the same with x_{n+1} = x_n + v_n dt.
/// `runge_kutta_4`: the classical one.
/// `taguchi_euler`: x_{n+1} = x_n + v_n dt + a_n dt^2/2, v_{n+1} = v_n + a_n dt (Taguchi, Eqs. 7
/// and 8) at a fixed time step; `taguchi_adaptive_euler`: with the time step of his Eqs. 9 and 10,
/// of which Scene::dt is the largest.
enum class Integrator {
    verlet_half_step,
    verlet_predicted,
    leapfrog_crank_nicolson,
    semi_implicit_euler,
    explicit_euler,
    runge_kutta_4,
    taguchi_euler,
    taguchi_adaptive_euler
};
constexpr auto words(Integrator /*of*/) {
    return std::array{"verlet-half-step",    "verlet-predicted",      "leapfrog-crank-nicolson",
                      "semi-implicit-euler", "explicit-euler",        "runge-kutta-4",
                      "taguchi-euler",       "taguchi-adaptive-euler"};
}

/// Which pairs may touch: any two grains, or only the six that are neighbours in the triangular
/// lattice the run starts from (Taguchi, section 3), whatever passes through whatever.
enum class Contacts { neighbour_list, lattice_neighbours };
constexpr auto words(Contacts /*of*/) {
    return std::array{"neighbour-list", "lattice-neighbours"};
}

/// Arithmetic of the run: double throughout, or fixed-point positions with float velocities.
enum class Precision { double_precision, mixed };
constexpr auto words(Precision /*of*/) {
    return std::array{"double", "mixed"};
}

/// Whether a dashpot is as strong as it says, or per unit of the pair's effective mass
/// m_i m_j/(m_i + m_j), a frozen grain counting as infinitely heavy.
enum class DampingScale { absolute, effective_mass };
constexpr auto words(DampingScale /*of*/) {
    return std::array{"absolute", "effective-mass"};
}

/// Linear spring-dashpot contact between two discs:
/// F_i = k (d - r) n - eta (v_i - v_j), contact while r < d  (Taguchi, Eq. 1).
struct ContactLaw {
    double stiffness = 0;  ///< k (m/t^2), > 0
    double damping = 0;    ///< eta (m/t), >= 0, on the relative velocity of the pair
    Damping damping_acts_on = Damping::full_vector;
    Clipping clipping = Clipping::none;
    Spins spins = Spins::off;
    DampingScale damping_scale = DampingScale::absolute;
    std::optional<Friction> friction;  ///< needs spins on and normal-only damping
};

/// Elastic horizontal plate moving as y(t) = height + amplitude cos(2 pi (t/period + phase)).
struct PrescribedPlate {
    double height = 0;     ///< mean height (length)
    double amplitude = 0;  ///< b (length), >= 0; 0 is a plate at rest
    double period = 1;     ///< 2 pi / omega_0 (time), > 0
    double phase = 0;      ///< at t = 0, in periods
};

/// Elastic horizontal lid of finite mass under gravity (Taguchi, Eq. 2, with the -g that his
/// Appendix B implies).
struct FreeLid {
    double mass = 0;      ///< M, > 0
    double height = 0;    ///< at t = 0
    double velocity = 0;  ///< at t = 0
};

using Lid = std::variant<std::monostate, PrescribedPlate, FreeLid>;

/// Plates act on grains with the spring `stiffness` and no dissipation.
struct Plates {
    double stiffness = 0;  ///< (m/t^2), > 0 when there is a plate
    PlateContact touches = PlateContact::centre;
    std::optional<PrescribedPlate> bottom;
    Lid lid;
};

/// Elastic, frictionless vertical planes that push the *centres* of grains back between
/// them, with force stiffness * (distance behind the plane): the backing of a rough wall made of
/// frozen grains, so that nothing squeezes through it.
struct BackingPlanes {
    double stiffness = 0;        ///< (m/t^2), > 0
    double left = 0, right = 0;  ///< positions along x, left < right
};

/// State at t = 0, the same 17 digits for every code. All arrays have shape (grains).
struct InitialState {
    std::vector<double> x, y;    ///< positions (length), unwrapped
    std::vector<double> vx, vy;  ///< velocities at t = 0 (not at a half step)
    std::vector<double> omega;   ///< angular velocities (1/t), counter-clockwise; empty: all 0
    std::vector<bool> frozen;    ///< grains that never move; empty when there are none
};

/// What happens to the initial state before the run: it evolves under the scene's own laws, then
/// some grains are taken away, and the rest starts the run. A code never sees it:
/// adapters/run/preparation.
struct Preparation {
    std::int64_t steps = 0;     ///< > 0
    std::vector<bool> removed;  ///< shape (grains)
};

/// Grains that are all alike, or each with its own size and mass.
struct Grains {
    double diameter = 0;            ///< d, > 0; of grains that differ, the nominal one
    double mass = 0;                ///< m, > 0; the same
    std::vector<double> diameters;  ///< shape (grains); empty when all are alike
    std::vector<double> masses;     ///< shape (grains); empty when all are alike

    [[nodiscard]] bool differ() const noexcept { return !diameters.empty(); }
    [[nodiscard]] double diameter_of(std::size_t i) const {
        return differ() ? diameters[i] : diameter;
    }
    [[nodiscard]] double mass_of(std::size_t i) const { return differ() ? masses[i] : mass; }
};

/// One run. Built by the case reader; every field is resolved (no "default" is left to a code).
struct Scene {
    std::string name;  ///< case and variant, e.g. "collision-normal/full/dt3"
    Grains grains;
    ContactLaw contact;
    Plates plates;
    double gravity = 0;  ///< g, acts along -y, >= 0
    double drag = 0;     ///< force -drag * v on every grain (m/t), >= 0
    std::optional<BackingPlanes> backing;
    std::optional<double> periodic_x;  ///< period along x; open when absent
    std::optional<double> periodic_y;  ///< period along y; open when absent; excludes plates
    Integrator integrator = Integrator::verlet_half_step;
    Contacts contacts = Contacts::neighbour_list;
    Precision precision = Precision::double_precision;
    /// Pairs nearer than d + skin are in the neighbour list (length), > 0; absent: as each code
    /// does best. It decides what a run costs, not what comes out.
    std::optional<double> skin;
    double dt = 0;                 ///< time step, > 0
    std::int64_t steps = 0;        ///< multiple of frame_every, > 0
    std::int64_t frame_every = 0;  ///< frames at 0, frame_every, ..., steps
    std::uint64_t seed = 0;        ///< of the initial state
    InitialState initial;
    std::optional<Preparation> preparation;  ///< still to be done to `initial`

    [[nodiscard]] std::size_t grain_count() const noexcept { return initial.x.size(); }
    [[nodiscard]] bool has_free_lid() const noexcept {
        return std::holds_alternative<FreeLid>(plates.lid);
    }
    [[nodiscard]] bool has_frozen_grains() const noexcept { return !initial.frozen.empty(); }
    [[nodiscard]] bool has_friction() const noexcept { return contact.friction.has_value(); }
};

[[nodiscard]] double largest_diameter(const Grains& grains);

/// Half the time of a head-on collision's undamped-frequency cycle: t_col = pi / omega with
/// omega = sqrt(2 k/m - (eta/m)^2) (Taguchi, below Eq. 1). Infinite when overdamped.
[[nodiscard]] double contact_time(const Scene& scene);

/// 2 pi phase: the angle of a plate's motion at t = 0.
[[nodiscard]] double phase_angle(const PrescribedPlate& plate);

/// Height of a prescribed plate at time t.
[[nodiscard]] double height_at(const PrescribedPlate& plate, double t);

/// Separation along one axis to the nearest periodic image; unchanged without a period.
[[nodiscard]] double nearest_image(double separation, const std::optional<double>& period);

/// Number of pairs in contact and of grains in contact with a plate at t = 0.
[[nodiscard]] std::size_t initial_contacts(const Scene& scene);

}  // namespace crossgrain::scene
