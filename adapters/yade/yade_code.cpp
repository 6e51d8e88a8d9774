#include "adapters/yade/yade_code.hpp"

#include "adapters/program/error_line.hpp"
#include "adapters/program/native_choice.hpp"
#include "adapters/program/own_conventions.hpp"
#include "adapters/yade/left_folders.hpp"
#include "adapters/yade/module_files.hpp"
#include "adapters/yade/scene_script.hpp"
#include "adapters/yade/yade_errors.hpp"
#include "cases/scene/scene_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <variant>

namespace crossgrain::adapters {

namespace {

// Not the name of a Python module: YADE's own imports would find the script instead.
constexpr const char* script_name = "scene.py";

/// "2023.02a" from "Yade version: 2023.02a"; nothing if the text is something else.
std::optional<std::string> version_in(const std::string& text) {
    constexpr std::string_view mark = "Yade version: ";
    const auto line = line_starting_with(text, mark);
    if (!line || line->size() <= mark.size()) return std::nullopt;
    return line->substr(mark.size());
}

/// Why a period of the scene is too short for YADE, or nothing.
std::optional<std::string> too_short(const std::optional<double>& period, char axis,
                                     double diameter) {
    if (!period || *period > 2 * diameter) return std::nullopt;
    return fmt::format("the period {:g} along {} is not larger than two diameters, and a pair of "
                       "bodies has at most one contact in YADE",
                       *period, axis);
}

bool has_plates(const scene::Scene& scene) {
    return scene.plates.bottom.has_value() ||
           !std::holds_alternative<std::monostate>(scene.plates.lid);
}

/// Why neither of YADE's laws is this friction, or nothing. Without a dashpot along the normal the
/// force is never attractive, and clipping it or not is the same.
std::optional<std::string> other_friction(const scene::Scene& scene) {
    const auto& law = scene.contact;
    if (!law.friction || law.damping == 0 || law.clipping != scene::Clipping::none)
        return std::nullopt;
    const auto& friction = *law.friction;
    if (friction.force == scene::TangentialForce::dashpot) {
        return "the law that keeps the attraction (LudingMat) puts no Coulomb limit on a dashpot "
               "(clipping all or normal-only, or force spring with the damping of the normal, "
               "would be expressible)";
    }
    if (friction.damping == law.damping) return std::nullopt;
    return fmt::format("the law that keeps the attraction (LudingMat) has one damping for normal "
                       "and tangent, not {:g} and {:g} (clipping all or normal-only, or a "
                       "tangential damping of {:g}, would be expressible)",
                       law.damping, friction.damping, law.damping);
}

}  // namespace

std::vector<std::string> YadeCode::version_arguments() const {
    return {"--version"};
}

Availability YadeCode::availability_from(const std::string& answer) const {
    yade::sweep_folders();
    if (const auto version = version_in(answer)) return {.installed = true, .version = *version};
    return {.reason = fmt::format("'{} --version' does not name a version of YADE", program())};
}

std::vector<std::filesystem::path>
YadeCode::further_files(const std::filesystem::path& executable) const {
    return yade::module_files(executable);
}

std::vector<std::string> YadeCode::features() const {
    return {"contact: spring-dashpot, full-vector or normal-only damping",
            "clipping: none, all, normal-only",
            "damping: absolute, per effective mass",
            "spins: off, on",
            "friction: spring or dashpot with Coulomb limit, conventions yade; with the attraction "
            "left in, only a spring whose tangential damping is that of the normal",
            "grains that differ, drag, backing planes",
            "plates: centre or surface; bottom at rest or prescribed; lid prescribed or free",
            "gravity, frozen grains, open or periodic along x and y",
            "integrator: verlet-half-step"};
}

std::optional<std::string> YadeCode::cannot_express(const scene::Scene& scene) const {
    if (scene.integrator != scene::Integrator::verlet_half_step) {
        return "NewtonIntegrator evaluates the dashpots at the half-step velocity only "
               "(integrator verlet-half-step would be expressible)";
    }
    if (auto reason = native_choice(scene)) return reason;
    if (auto reason = foreign_conventions(scene, "yade")) return reason;
    if (auto reason = other_friction(scene)) return reason;
    const double diameter = scene::largest_diameter(scene.grains);
    if (auto reason = too_short(scene.periodic_x, 'x', diameter)) return reason;
    return too_short(scene.periodic_y, 'y', diameter);
}

std::vector<InputFile> YadeCode::input(const scene::Scene& scene) const {
    nlohmann::json data = scene::to_json(scene);
    data.erase("name");  // no text from outside gets into the input of a code
    std::vector<InputFile> files{{.name = script_name, .text = std::string(yade::scene_script())},
                                 {.name = "scene.json", .text = data.dump(1) + "\n"},
                                 {.name = "laws.py", .text = std::string(yade::laws_script())}};
    if (has_plates(scene) || scene.backing) {
        files.push_back({.name = "plates.py", .text = std::string(yade::plates_script())});
    }
    return files;
}

std::vector<std::string> YadeCode::run_arguments() const {
    return {"-n", "-x", "-j1", script_name};
}

std::vector<std::string> YadeCode::environment() const {
    // The directory of the run: settings of the user's own YADE or IPython must not matter.
    return {"HOME=."};
}

std::optional<std::string> YadeCode::error_in(const std::string& stdout_text,
                                              const std::string& stderr_text) const {
    const auto found = yade::first_error(stderr_text);
    return found ? found : yade::first_error(stdout_text);
}

}  // namespace crossgrain::adapters
