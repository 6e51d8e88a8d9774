// Friction between rotating discs. The law is the same in all codes, but no two codes agree on how
// they follow the contact from step to step; those choices have names here, so that a scene can say
// which it wants, a code can refuse what it does not have, and a difference can be attributed.
#pragma once

#include "native/base/enum_words.hpp"

#include <optional>
#include <string>

namespace crossgrain::scene {

using crossgrain::to_string;

/// `spring`: a tangential spring xi' = v_t with a Coulomb limit, F_t = -k_t xi - gamma_t v_t.
/// `dashpot`: no history, F_t = -gamma_t v_t with the same limit.
enum class TangentialForce { spring, dashpot };
constexpr auto words(TangentialForce /*of*/) {
    return std::array{"spring", "dashpot"};
}

/// The arm from a grain's centre to the contact: its radius r, or r - delta/2 with the overlap
/// delta (of two grains alike the middle of the overlap).
enum class Lever { radius, contact_point };
constexpr auto words(Lever /*of*/) {
    return std::array{"radius", "contact-point"};
}

/// How a stored spring follows the turning of the normal by an angle a in one step: projected onto
/// the new tangent (shorter by cos a), projected and rescaled to its old length, or rotated,
/// s -= s x (n_old x n_new), which makes it longer by 1 + a^2/2.
enum class SpringRotation { project, project_and_rescale, rotate };
constexpr auto words(SpringRotation /*of*/) {
    return std::array{"project", "project-and-rescale", "rotate"};
}

/// What is cut at mu |F_n|: spring and dashpot together, the spring being set so that their sum is
/// at the limit; or the spring alone, the dashpot being added only while the contact sticks.
enum class CoulombLimit { total, spring_only };
constexpr auto words(CoulombLimit /*of*/) {
    return std::array{"total", "spring-only"};
}

struct FrictionConventions {
    Lever velocity_lever = Lever::contact_point;  ///< arm of the spin in the tangential velocity
    Lever torque_lever = Lever::contact_point;    ///< arm of the tangential force in the torque
    SpringRotation rotation = SpringRotation::project;
    CoulombLimit limit = CoulombLimit::spring_only;
    friend bool operator==(const FrictionConventions&, const FrictionConventions&) = default;
};

/// Coulomb friction with the limit mu |F_n|, F_n being the whole normal force after clipping.
/// Grains rotate, with the moment of inertia I = inertia_factor m r^2.
struct Friction {
    TangentialForce force = TangentialForce::spring;
    double coefficient = 0;       ///< mu, >= 0
    double stiffness = 0;         ///< k_t (m/t^2), > 0 for `spring`, 0 for `dashpot`
    double damping = 0;           ///< gamma_t (m/t), >= 0, scales like ContactLaw::damping
    double inertia_factor = 0.5;  ///< 1/2: disc, 2/5: sphere; in (0, 1]
    /// Absent: every code takes its own ("own" in a case file). Then codes differ by design, and
    /// only statistics of theirs can be compared.
    std::optional<FrictionConventions> conventions;
};

/// The conventions of a law of one of the codes: "lammps-granular", "lammps-hooke-history",
/// "liggghts", "yade"; nothing for any other name.
[[nodiscard]] std::optional<FrictionConventions> conventions_named(const std::string& name);

/// The name above, or the four choices in words when it is none of them.
[[nodiscard]] std::string to_string(const FrictionConventions& conventions);

}  // namespace crossgrain::scene
