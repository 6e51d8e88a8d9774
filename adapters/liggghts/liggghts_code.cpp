#include "adapters/liggghts/liggghts_code.hpp"

#include "adapters/dump/data_writer.hpp"
#include "adapters/liggghts/liggghts_script.hpp"
#include "adapters/process/find_program.hpp"
#include "adapters/program/error_line.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace crossgrain::adapters {

namespace {

constexpr const char* script_name = "in.liggghts";
constexpr const char* data_name = "data.txt";

/// "3.8.0" from the help's "LIGGGHTS (Version LIGGGHTS-PUBLIC 3.8.0, compiled ...".
std::string version_in(const std::string& help) {
    constexpr std::string_view mark = "(Version ";
    const std::size_t start = help.find(mark);
    if (start == std::string::npos) return "unknown version";
    const std::size_t end = help.find_first_of(",)\n", start);
    const std::string version = help.substr(start + mark.size(), end - start - mark.size());
    return version.substr(version.rfind(' ') + 1);
}

}  // namespace

LiggghtsCode::LiggghtsCode(std::string program) : program_(std::move(program)) {}

Availability LiggghtsCode::probe() const {
    const std::scoped_lock lock(mutex_);
    if (availability_) return *availability_;
    Availability found;
    constexpr double time_limit = 20;
    if (!process::find_program(program_)) {
        found.reason = fmt::format("no '{}' on PATH", program_);
    } else if (const auto help = process::output_of({program_, "-h", "-log", "none"}, time_limit);
               !help) {
        found.reason = fmt::format("'{} -h' does not run", program_);
    } else {
        found = {.installed = true, .version = version_in(*help), .reason = {}};
    }
    availability_ = found;
    return found;
}

std::vector<std::string> LiggghtsCode::features() const {
    return {"contact: spring-dashpot, full-vector or normal-only damping",
            "clipping: none, all",
            "spins: off, on",
            "plates: centre or surface; bottom at rest or prescribed; lid prescribed or free",
            "gravity, frozen grains, open or periodic along x and y",
            "integrator: verlet-half-step"};
}

std::optional<std::string> LiggghtsCode::cannot_express(const scene::Scene& scene) const {
    if (scene.integrator != scene::Integrator::verlet_half_step) {
        return "fix nve evaluates the dashpots at the half-step velocity only "
               "(integrator verlet-half-step would be expressible)";
    }
    if (has_tangential_dashpot(scene.contact) &&
        scene.contact.clipping == scene::Clipping::normal_only) {
        return "limitForce cuts the tangential dashpot together with the normal force "
               "(clipping none or all would be expressible)";
    }
    return std::nullopt;
}

std::vector<InputFile> LiggghtsCode::input(const scene::Scene& scene) const {
    return {{.name = script_name, .text = liggghts_script(scene, data_name, dump_name)},
            {.name = data_name, .text = dump::data_file(scene)}};
}

std::vector<std::string> LiggghtsCode::command_line() const {
    return {program_, "-in", script_name, "-log", "none", "-nocite"};
}

std::vector<std::string> LiggghtsCode::environment() const {
    return {"OMP_NUM_THREADS=1"};
}

std::optional<std::string> LiggghtsCode::error_in(const std::string& stdout_text,
                                                  const std::string& stderr_text) const {
    const auto found = line_starting_with(stdout_text, "ERROR");
    return found ? found : line_starting_with(stderr_text, "ERROR");
}

}  // namespace crossgrain::adapters
