#include "adapters/lammps/lammps_code.hpp"

#include "adapters/dump/data_writer.hpp"
#include "adapters/lammps/lammps_script.hpp"
#include "adapters/process/find_program.hpp"
#include "adapters/program/error_line.hpp"

#include <fmt/format.h>

#include <utility>

namespace crossgrain::adapters {

namespace {

constexpr const char* script_name = "in.lammps";
constexpr const char* data_name = "data.txt";

/// "29 Sep 2021 - Update 2" from the help's "Large-scale ... Simulator - 29 Sep 2021 - Update 2".
std::string version_in(const std::string& help) {
    const auto line = line_starting_with(help, "Large-scale");
    const std::size_t start = line ? line->find(" - ") : std::string::npos;
    return start == std::string::npos ? "unknown version" : line->substr(start + 3);
}

}  // namespace

LammpsCode::LammpsCode(std::string program) : program_(std::move(program)) {}

Availability LammpsCode::probe() const {
    const std::scoped_lock lock(mutex_);
    if (availability_) return *availability_;
    Availability found;
    constexpr double time_limit = 20;
    if (!process::find_program(program_)) {
        found.reason = fmt::format("no '{}' on PATH", program_);
    } else if (const auto help = process::output_of({program_, "-h"}, time_limit); !help) {
        found.reason = fmt::format("'{} -h' does not run", program_);
    } else if (help->find("granular") == std::string::npos) {
        found.reason = fmt::format("'{}' is built without pair style granular", program_);
    } else {
        found = {.installed = true, .version = version_in(*help), .reason = {}};
    }
    availability_ = found;
    return found;
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
    const bool tangential_dashpot =
        law.damping_acts_on == scene::Damping::full_vector && law.damping > 0;
    if (scene.integrator != scene::Integrator::verlet_half_step) {
        return "fix nve evaluates the dashpots at the half-step velocity only "
               "(integrator verlet-half-step would be expressible)";
    }
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

std::vector<InputFile> LammpsCode::input(const scene::Scene& scene) const {
    return {{.name = script_name, .text = lammps_script(scene, data_name, dump_name)},
            {.name = data_name, .text = dump::data_file(scene)}};
}

std::vector<std::string> LammpsCode::command_line() const {
    // Not -screen none: with it, errors are not printed anywhere.
    return {program_, "-in", script_name, "-log", "none", "-nocite"};
}

std::vector<std::string> LammpsCode::environment() const {
    return {"OMP_NUM_THREADS=1"};
}

std::optional<std::string> LammpsCode::error_in(const std::string& stdout_text,
                                                const std::string& stderr_text) const {
    const auto found = line_starting_with(stdout_text, "ERROR");
    return found ? found : line_starting_with(stderr_text, "ERROR");
}

}  // namespace crossgrain::adapters
