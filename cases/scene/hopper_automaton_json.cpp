#include "cases/scene/model_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace crossgrain::scene {
namespace {

using nlohmann::json;

// The reading's name is a label: what it stands for decides the numbers.
json rules_json(const HopperReading& reading) {
    return {{"sweep", to_string(reading.sweep)},
            {"rows", to_string(reading.rows)},
            {"inertia", to_string(reading.inertia)},
            {"rotation", reading.rotation},
            {"tie_tolerance", reading.tie_tolerance}};
}

json angles_json(const std::vector<double>& angles) {
    constexpr std::size_t listed = 12;  // more are a sweep: its ends and its length say it all
    if (angles.size() <= listed) return angles;
    return fmt::format("{} from {:g} to {:g}", angles.size(), angles.front(), angles.back());
}

}  // namespace

json to_json(const HopperAutomaton& scene) {
    return {{"model", "hopper-automaton"},
            {"name", scene.name},
            {"rules", rules_json(scene.reading)},
            {"outlet", scene.outlet},
            {"levels", scene.levels},
            {"angles", scene.angles},
            {"c_d", scene.c_d},
            {"c_o", scene.c_o},
            {"c_i", scene.c_i},
            {"c_w", scene.c_w},
            {"iterations", scene.iterations},
            {"every", scene.every},
            {"replicas", scene.replicas},
            {"flipped", scene.flipped},
            {"random", to_string(scene.random)},
            {"engine", to_string(scene.engine)},
            {"seed", scene.seed}};
}

json settings_json(const HopperAutomaton& scene) {
    json settings{{"reading", scene.reading.name},
                  {"outlet", scene.outlet},
                  {"levels", scene.levels},
                  {"angles", angles_json(scene.angles)},
                  {"c_d", scene.c_d},
                  {"c_o", scene.c_o},
                  {"c_i", scene.c_i},
                  {"c_w", scene.c_w},
                  {"tie_tolerance", scene.reading.tie_tolerance},
                  {"iterations", scene.iterations},
                  {"every", scene.every},
                  {"replicas", scene.replicas},
                  {"random", to_string(scene.random)},
                  {"engine", to_string(scene.engine)},
                  {"seed", scene.seed}};
    if (scene.flipped > 0) settings["flipped"] = scene.flipped;
    return settings;
}

}  // namespace crossgrain::scene
