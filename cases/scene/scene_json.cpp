#include "cases/scene/scene_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace crossgrain::scene {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BackingPlanes, stiffness, left, right)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Preparation, steps, removed)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FreeLid, mass, height, velocity)

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

json conventions_json(const std::optional<FrictionConventions>& conventions) {
    if (!conventions) return "own";
    return {{"velocity_lever", to_string(conventions->velocity_lever)},
            {"torque_lever", to_string(conventions->torque_lever)},
            {"rotation", to_string(conventions->rotation)},
            {"limit", to_string(conventions->limit)}};
}

json friction_json(const Friction& friction) {
    return {{"force", to_string(friction.force)},
            {"coefficient", friction.coefficient},
            {"stiffness", friction.stiffness},
            {"damping", friction.damping},
            {"inertia_factor", friction.inertia_factor},
            {"conventions", conventions_json(friction.conventions)}};
}

/// Choices of which the first is so usual that it is not written: what was said of a scene before
/// there was a choice stays said.
void add_unusual_choices(const Scene& scene, json& result) {
    if (scene.contacts != Contacts::neighbour_list) result["contacts"] = to_string(scene.contacts);
    if (scene.precision != Precision::double_precision) {
        result["precision"] = to_string(scene.precision);
    }
    if (scene.skin) result["skin"] = *scene.skin;
    if (scene.drag != 0) result["drag"] = scene.drag;
    if (scene.backing) result["backing"] = *scene.backing;
    if (scene.preparation) result["preparation"] = *scene.preparation;
}

json lid_json(const Lid& lid) {
    if (const auto* plate = std::get_if<PrescribedPlate>(&lid)) return plate_json(*plate);
    if (const auto* free_lid = std::get_if<FreeLid>(&lid)) return *free_lid;
    return nullptr;
}

json contact_json(const ContactLaw& law) {
    json result{{"stiffness", law.stiffness},
                {"damping_coefficient", law.damping},
                {"damping", to_string(law.damping_acts_on)},
                {"clipping", to_string(law.clipping)},
                {"spins", to_string(law.spins)}};
    if (law.damping_scale != DampingScale::absolute) {
        result["damping_scale"] = to_string(law.damping_scale);
    }
    if (law.friction) result["friction"] = friction_json(*law.friction);
    return result;
}

json grains_json(const Grains& grains) {
    json result{{"diameter", grains.diameter}, {"mass", grains.mass}};
    if (grains.differ()) {
        result["diameters"] = grains.diameters;
        result["masses"] = grains.masses;
    }
    return result;
}

json initial_json(const InitialState& state) {
    json result{{"x", state.x},
                {"y", state.y},
                {"vx", state.vx},
                {"vy", state.vy},
                {"frozen", state.frozen}};
    if (!state.omega.empty()) result["omega"] = state.omega;
    return result;
}

void add_friction_settings(const Scene& scene, json& settings) {
    if (scene.grains.differ()) {
        const auto [least, most] =
            std::minmax_element(scene.grains.diameters.begin(), scene.grains.diameters.end());
        settings["diameters"] = fmt::format("{:.4g} to {:.4g}", *least, *most);
    }
    if (scene.contact.damping_scale != DampingScale::absolute) {
        settings["damping_scale"] = to_string(scene.contact.damping_scale);
    }
    if (!scene.contact.friction) return;
    const Friction& friction = *scene.contact.friction;
    settings["friction"] = fmt::format(
        "{}, mu {:g}, k_t {:g}, gamma_t {:g}, I = {:g} m r^2", to_string(friction.force),
        friction.coefficient, friction.stiffness, friction.damping, friction.inertia_factor);
    settings["conventions"] =
        friction.conventions ? to_string(*friction.conventions) : std::string("own");
}

}  // namespace

json to_json(const Scene& scene) {
    json result{{"name", scene.name},
                {"grains", grains_json(scene.grains)},
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
                {"initial", initial_json(scene.initial)}};
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
    add_friction_settings(scene, settings);
    return settings;
}

}  // namespace crossgrain::scene
