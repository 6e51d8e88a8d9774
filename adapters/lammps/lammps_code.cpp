#include "adapters/lammps/lammps_code.hpp"

#include "adapters/lammps/lammps_script.hpp"
#include "adapters/lammps_family/family_script.hpp"
#include "adapters/program/error_line.hpp"
#include "adapters/program/native_choice.hpp"
#include "adapters/program/own_conventions.hpp"

#include <fmt/format.h>

namespace crossgrain::adapters {

namespace {

using lammps_family::disc_inertia;
using lammps_family::sphere_inertia;

/// "29 Sep 2021 - Update 2" from the help's "Large-scale ... Simulator - 29 Sep 2021 - Update 2";
/// nothing if the text is something else.
std::optional<std::string> version_in(const std::string& help) {
    const auto line = line_starting_with(help, "Large-scale");
    const std::size_t start = line ? line->find(" - ") : std::string::npos;
    if (start == std::string::npos || start + 3 >= line->size()) return std::nullopt;
    return line->substr(start + 3);
}

/// Why no pair style follows contacts as the scene says, or nothing.
std::optional<std::string> other_conventions(const scene::ContactLaw& law) {
    if (!law.friction || !law.friction->conventions) return std::nullopt;
    const auto& asked = *law.friction->conventions;
    for (const char* own : {"lammps-granular", "lammps-hooke-history"}) {
        if (same_force(*law.friction, asked, scene::conventions_named(own).value())) {
            return std::nullopt;
        }
    }
    return fmt::format("a frictional contact is followed from step to step as \"lammps-granular\" "
                       "or \"lammps-hooke-history\" say, not as in {} (these conventions, or own, "
                       "would be expressible)",
                       to_string(asked));
}

/// Why the dashpots of this friction are not those of its pair style, or nothing.
std::optional<std::string> other_dashpots(const scene::Scene& scene) {
    const auto& law = scene.contact;
    if (pair_style(law) == PairStyle::granular) {
        if (law.friction->damping == 0 || law.damping > 0) return std::nullopt;
        return "pair style granular has the tangential dashpot as a multiple of the normal one, "
               "which is 0 (conventions lammps-hooke-history would be expressible)";
    }
    const bool any = law.damping > 0 || law.friction->damping > 0;
    if (law.damping_scale == scene::DampingScale::absolute && any && scene.grains.differ()) {
        return "pair style gran/hooke/history damps per unit of the effective mass, and these "
               "grains differ (damping_scale effective-mass, or conventions lammps-granular, would "
               "be expressible)";
    }
    return std::nullopt;
}

std::optional<std::string> other_inertia(const scene::Friction& friction) {
    const double factor = friction.inertia_factor;
    if (factor == disc_inertia || factor == sphere_inertia) return std::nullopt;
    return fmt::format("fix nve/sphere takes the moment of inertia of a disc or of a sphere, not "
                       "{:g} m r^2 (inertia_factor {:g} or {:g} would be expressible)",
                       factor, disc_inertia, sphere_inertia);
}

std::optional<std::string> other_friction(const scene::Scene& scene) {
    if (!scene.has_friction()) return std::nullopt;
    if (auto reason = other_conventions(scene.contact)) return reason;
    if (auto reason = other_dashpots(scene)) return reason;
    return other_inertia(*scene.contact.friction);
}

}  // namespace

std::vector<std::string> LammpsCode::version_arguments() const {
    return {"-h"};
}

Availability LammpsCode::availability_from(const std::string& help) const {
    const auto version = version_in(help);
    if (!version) {
        return {.reason = fmt::format("'{} -h' does not name a version of LAMMPS", program())};
    }
    if (help.find("granular") == std::string::npos) {
        return {.reason = fmt::format("'{}' is built without pair style granular", program())};
    }
    return {.installed = true, .version = *version};
}

std::vector<std::string> LammpsCode::features() const {
    return {"contact: spring-dashpot, full-vector or normal-only damping",
            "clipping: none, all",
            "damping: absolute, per effective mass",
            "spins: off; on with friction",
            "friction: spring or dashpot with Coulomb limit, conventions lammps-granular and "
            "lammps-hooke-history, I = 1/2 or 2/5 m r^2",
            "grains that differ, drag, backing planes",
            "plates: centre or surface; bottom at rest or prescribed; lid prescribed or free",
            "gravity, frozen grains, open or periodic along x and y",
            "integrator: verlet-half-step"};
}

std::optional<std::string> LammpsCode::cannot_express(const scene::Scene& scene) const {
    const auto& law = scene.contact;
    const bool tangential_dashpot = lammps_family::has_tangential_dashpot(law);
    if (scene.integrator != scene::Integrator::verlet_half_step) {
        return "fix nve evaluates the dashpots at the half-step velocity only "
               "(integrator verlet-half-step would be expressible)";
    }
    if (auto reason = native_choice(scene)) return reason;
    if (auto reason = lammps_family::too_far_apart(scene)) return reason;
    if (tangential_dashpot && law.clipping == scene::Clipping::normal_only) {
        return "limit_damping cuts the tangential dashpot together with the normal force "
               "(clipping none or all would be expressible)";
    }
    if (tangential_dashpot && law.spins == scene::Spins::on) {
        return "pair style granular takes the velocity at distance d/2 from the centre but the "
               "torque at the point of contact (spins off would be expressible)";
    }
    if (auto reason = other_friction(scene)) return reason;
    if (auto reason = lammps_family::shared_springs(scene)) return reason;
    return lammps_family::unequal_reach(scene);
}

std::string LammpsCode::script(const scene::Scene& scene, const std::string& data_name) const {
    return lammps_script(scene, data_name, dump_name);
}

}  // namespace crossgrain::adapters
