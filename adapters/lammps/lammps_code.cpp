#include "adapters/lammps/lammps_code.hpp"

#include "adapters/lammps/lammps_script.hpp"
#include "adapters/lammps_family/family_script.hpp"
#include "adapters/program/error_line.hpp"
#include "adapters/program/native_choice.hpp"

#include <fmt/format.h>

namespace crossgrain::adapters {

namespace {

/// "29 Sep 2021 - Update 2" from the help's "Large-scale ... Simulator - 29 Sep 2021 - Update 2".
std::string version_in(const std::string& help) {
    const auto line = line_starting_with(help, "Large-scale");
    const std::size_t start = line ? line->find(" - ") : std::string::npos;
    return start == std::string::npos ? "unknown version" : line->substr(start + 3);
}

}  // namespace

std::vector<std::string> LammpsCode::version_arguments() const {
    return {"-h"};
}

Availability LammpsCode::availability_from(const std::string& help) const {
    if (help.find("granular") == std::string::npos) {
        return {.reason = fmt::format("'{}' is built without pair style granular", program())};
    }
    return {.installed = true, .version = version_in(help)};
}

std::vector<std::string> LammpsCode::features() const {
    return {"contact: spring-dashpot, full-vector or normal-only damping",
            "clipping: none, all",
            "spins: off",
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
    if (tangential_dashpot && law.clipping == scene::Clipping::normal_only) {
        return "limit_damping cuts the tangential dashpot together with the normal force "
               "(clipping none or all would be expressible)";
    }
    if (tangential_dashpot && law.spins == scene::Spins::on) {
        return "pair style granular takes the velocity at distance d/2 from the centre but the "
               "torque at the point of contact (spins off would be expressible)";
    }
    return std::nullopt;
}

std::string LammpsCode::script(const scene::Scene& scene, const std::string& data_name) const {
    return lammps_script(scene, data_name, dump_name);
}

}  // namespace crossgrain::adapters
