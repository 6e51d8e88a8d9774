#include "adapters/liggghts/liggghts_code.hpp"

#include "adapters/lammps_family/family_script.hpp"
#include "adapters/liggghts/liggghts_script.hpp"
#include "adapters/program/native_choice.hpp"
#include "adapters/program/own_conventions.hpp"

#include <fmt/format.h>

#include <string_view>

namespace crossgrain::adapters {

namespace {

/// "3.8.0" from the help's "LIGGGHTS (Version LIGGGHTS-PUBLIC 3.8.0, compiled ..."; nothing if the
/// text is something else.
std::optional<std::string> version_in(const std::string& help) {
    constexpr std::string_view mark = "LIGGGHTS (Version ";
    const std::size_t start = help.find(mark);
    if (start == std::string::npos) return std::nullopt;
    const std::size_t end = help.find_first_of(",)\n", start);
    std::string version = help.substr(start + mark.size(), end - start - mark.size());
    version.erase(0, version.rfind(' ') + 1);
    if (version.empty()) return std::nullopt;
    return version;
}

/// Why fix nve/sphere cannot turn the grains of this scene, or nothing.
std::optional<std::string> other_inertia(const scene::Scene& scene) {
    using lammps_family::disc_inertia, lammps_family::sphere_inertia;
    if (!scene.has_friction()) return std::nullopt;
    const double factor = scene.contact.friction->inertia_factor;
    if (factor == disc_inertia || factor == sphere_inertia) return std::nullopt;
    return fmt::format("fix nve/sphere takes the moment of inertia of a disc or of a sphere, not "
                       "{:g} m r^2 (inertia_factor {:g} or {:g} would be expressible)",
                       factor, disc_inertia, sphere_inertia);
}

}  // namespace

std::vector<std::string> LiggghtsCode::version_arguments() const {
    return {"-h", "-log", "none"};
}

Availability LiggghtsCode::availability_from(const std::string& help) const {
    if (const auto version = version_in(help)) return {.installed = true, .version = *version};
    return {.reason = fmt::format("'{} -h' does not name a version of LIGGGHTS", program())};
}

std::vector<std::string> LiggghtsCode::features() const {
    return {"contact: spring-dashpot, full-vector or normal-only damping",
            "clipping: none, all",
            "damping: absolute, per effective mass",
            "spins: off, on",
            "friction: spring or dashpot with Coulomb limit, conventions liggghts, "
            "I = 1/2 or 2/5 m r^2",
            "grains that differ, drag, backing planes",
            "plates: centre or surface; bottom at rest or prescribed; lid prescribed or free",
            "gravity, frozen grains, open or periodic along x and y",
            "integrator: verlet-half-step"};
}

std::optional<std::string> LiggghtsCode::cannot_express(const scene::Scene& scene) const {
    if (scene.integrator != scene::Integrator::verlet_half_step) {
        return "fix nve evaluates the dashpots at the half-step velocity only "
               "(integrator verlet-half-step would be expressible)";
    }
    if (auto reason = native_choice(scene)) return reason;
    if (auto reason = lammps_family::too_far_apart(scene)) return reason;
    if (lammps_family::has_tangential_dashpot(scene.contact) &&
        scene.contact.clipping == scene::Clipping::normal_only) {
        return "limitForce cuts the tangential dashpot together with the normal force "
               "(clipping none or all would be expressible)";
    }
    if (auto reason = foreign_conventions(scene, "liggghts")) return reason;
    if (auto reason = other_inertia(scene)) return reason;
    if (auto reason = lammps_family::shared_springs(scene)) return reason;
    return lammps_family::unequal_reach(scene);
}

std::string LiggghtsCode::script(const scene::Scene& scene, const std::string& data_name) const {
    return liggghts_script(scene, data_name, dump_name);
}

}  // namespace crossgrain::adapters
