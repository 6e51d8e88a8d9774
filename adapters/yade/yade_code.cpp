#include "adapters/yade/yade_code.hpp"

#include "adapters/program/error_line.hpp"
#include "adapters/program/native_choice.hpp"
#include "adapters/yade/scene_script.hpp"
#include "adapters/yade/yade_errors.hpp"
#include "cases/scene/scene_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <variant>

namespace crossgrain::adapters {

namespace {

// Not the name of a Python module: YADE's own imports would find the script instead.
constexpr const char* script_name = "scene.py";

/// "2023.02a" from "Yade version: 2023.02a"; nothing if the text is something else.
std::optional<std::string> version_in(const std::string& text) {
    constexpr std::string_view mark = "Yade version: ";
    const auto line = line_starting_with(text, mark);
    if (!line) return std::nullopt;
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

}  // namespace

std::vector<std::string> YadeCode::version_arguments() const {
    return {"--version"};
}

Availability YadeCode::availability_from(const std::string& answer) const {
    if (const auto version = version_in(answer)) return {.installed = true, .version = *version};
    return {.reason = fmt::format("'{} --version' does not name a version of YADE", program())};
}

std::vector<std::string> YadeCode::features() const {
    return {"contact: spring-dashpot, full-vector or normal-only damping",
            "clipping: none, all, normal-only",
            "spins: off, on",
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
    if (auto reason = too_short(scene.periodic_x, 'x', scene.grains.diameter)) return reason;
    return too_short(scene.periodic_y, 'y', scene.grains.diameter);
}

std::vector<InputFile> YadeCode::input(const scene::Scene& scene) const {
    std::vector<InputFile> files{
        {.name = script_name, .text = std::string(yade::scene_script())},
        {.name = "scene.json", .text = scene::to_json(scene).dump(1) + "\n"}};
    if (has_plates(scene)) {
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
