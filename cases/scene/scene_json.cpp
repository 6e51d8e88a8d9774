#include "cases/scene/scene_json.hpp"

#include <nlohmann/json.hpp>

namespace crossgrain::scene {
namespace {

using nlohmann::json;

json period_json(const std::optional<double>& period) {
    return period ? json(*period) : json();
}

json plate_json(const PrescribedPlate& plate) {
    json result{{"height", plate.height}, {"amplitude", plate.amplitude}, {"period", plate.period}};
    if (plate.phase != 0) result["phase"] = plate.phase;
    return result;
}

/// Choices of which the first is so usual that it is not written: what was said of a scene before
/// there was a choice stays said.
void add_unusual_choices(const Scene& scene, json& result) {
    if (scene.contacts != Contacts::neighbour_list) result["contacts"] = to_string(scene.contacts);
    if (scene.precision != Precision::double_precision) {
        result["precision"] = to_string(scene.precision);
    }
}

json lid_json(const Lid& lid) {
    if (const auto* plate = std::get_if<PrescribedPlate>(&lid)) return plate_json(*plate);
    if (const auto* free_lid = std::get_if<FreeLid>(&lid)) {
        return {{"mass", free_lid->mass},
                {"height", free_lid->height},
                {"velocity", free_lid->velocity}};
    }
    return nullptr;
}

json contact_json(const ContactLaw& law) {
    return {{"stiffness", law.stiffness},
            {"damping_coefficient", law.damping},
            {"damping", to_string(law.damping_acts_on)},
            {"clipping", to_string(law.clipping)},
            {"spins", to_string(law.spins)}};
}

}  // namespace

json to_json(const Scene& scene) {
    json result{{"name", scene.name},
                {"grains", {{"diameter", scene.grains.diameter}, {"mass", scene.grains.mass}}},
                {"contact", contact_json(scene.contact)},
                {"plates",
                 {{"stiffness", scene.plates.stiffness},
                  {"touch", to_string(scene.plates.touches)},
                  {"bottom", scene.plates.bottom ? plate_json(*scene.plates.bottom) : json()},
                  {"lid", lid_json(scene.plates.lid)}}},
                {"gravity", scene.gravity},
                {"periodic_x", period_json(scene.periodic_x)},
                {"periodic_y", period_json(scene.periodic_y)},
                {"integrator", to_string(scene.integrator)},
                {"dt", scene.dt},
                {"steps", scene.steps},
                {"frame_every", scene.frame_every},
                {"seed", scene.seed},
                {"initial",
                 {{"x", scene.initial.x},
                  {"y", scene.initial.y},
                  {"vx", scene.initial.vx},
                  {"vy", scene.initial.vy},
                  {"frozen", scene.initial.frozen}}}};
    add_unusual_choices(scene, result);
    return result;
}

json settings_json(const Scene& scene) {
    json settings{{"dt", scene.dt},
                  {"steps", scene.steps},
                  {"frame_every", scene.frame_every},
                  {"grains", scene.grain_count()},
                  {"damping", to_string(scene.contact.damping_acts_on)},
                  {"clipping", to_string(scene.contact.clipping)},
                  {"spins", to_string(scene.contact.spins)},
                  {"integrator", to_string(scene.integrator)}};
    const bool has_lid = !std::holds_alternative<std::monostate>(scene.plates.lid);
    if (scene.plates.bottom || has_lid) settings["plates_touch"] = to_string(scene.plates.touches);
    add_unusual_choices(scene, settings);
    return settings;
}

}  // namespace crossgrain::scene
