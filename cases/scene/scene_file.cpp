#include "cases/scene/scene_file.hpp"

#include "cases/scene/contact_file.hpp"
#include "cases/scene/exclusive_keys.hpp"
#include "cases/scene/initial_state_file.hpp"
#include "cases/scene/limits.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace crossgrain::scene {
namespace {

using toml_input::Range;
using toml_input::TomlTable;

const std::array<std::string, 2> touch_words{"centre", "surface"};
const std::array<std::string, 8> integrator_words{
    "verlet-half-step", "verlet-predicted", "leapfrog-crank-nicolson", "semi-implicit-euler",
    "explicit-euler",   "runge-kutta-4",    "taguchi-euler",           "taguchi-adaptive-euler"};
const std::array<std::string, 2> contacts_words{"neighbour-list", "lattice-neighbours"};
const std::array<std::string, 2> precision_words{"double", "mixed"};

Grains read_grains(const TomlTable& t) {
    return {.diameter = t.number("diameter", Range::positive()),
            .mass = t.number("mass", Range::positive())};
}

SizeSpread read_sizes(const TomlTable& t) {
    SizeSpread sizes;
    if (const auto spread = t.optional_number("diameter_spread", Range::not_negative())) {
        if (*spread >= 1) {
            throw t.error("diameter_spread", "is out of range", fmt::format("{:g}", *spread),
                          "a number in [0, 1)", "0.05 is 5 % to either side");
        }
        sizes.spread = *spread;
    }
    if (const auto exponent = t.optional_number("mass_exponent", Range::not_negative())) {
        sizes.mass_exponent = *exponent;
    }
    t.reject_unknown_keys();
    return sizes;
}

BackingPlanes read_backing(const TomlTable& t, double contact_stiffness) {
    const BackingPlanes planes{
        .stiffness = t.optional_number("stiffness", Range::positive()).value_or(contact_stiffness),
        .left = t.number("left", Range::any()),
        .right = t.number("right", Range::any())};
    if (planes.left >= planes.right) {
        throw t.error("right", "is out of range", fmt::format("{:g}", planes.right),
                      fmt::format("a number > left = {:g}", planes.left));
    }
    t.reject_unknown_keys();
    return planes;
}

PrescribedPlate read_prescribed_plate(const TomlTable& t) {
    const PrescribedPlate plate{
        .height = t.number("height", Range::any()),
        .amplitude = t.optional_number("amplitude", Range::not_negative()).value_or(0),
        .period = t.optional_number("period", Range::positive()).value_or(1),
        .phase = t.optional_number("phase", Range::any()).value_or(0)};
    if (plate.amplitude > 0 && !t.has("period")) {
        throw t.missing("period", "the period of the plate's motion");
    }
    t.reject_unknown_keys();
    return plate;
}

Lid read_lid(const TomlTable& t) {
    if (!t.has("mass")) return read_prescribed_plate(t);
    const FreeLid lid{.mass = t.number("mass", Range::positive()),
                      .height = t.optional_number("height", Range::any()).value_or(0),
                      .velocity = t.optional_number("velocity", Range::any()).value_or(0)};
    t.reject_unknown_keys();
    return lid;
}

Plates read_plates(const TomlTable& t, double contact_stiffness) {
    Plates plates;
    plates.touches = static_cast<PlateContact>(t.choice("touch", touch_words));
    plates.stiffness =
        t.optional_number("stiffness", Range::positive()).value_or(contact_stiffness);
    if (t.has("bottom")) plates.bottom = read_prescribed_plate(t.table("bottom"));
    if (t.has("lid")) plates.lid = read_lid(t.table("lid"));
    t.reject_unknown_keys();
    return plates;
}

/// Gamma = b omega_0^2/g: the bottom's largest acceleration in units of gravity, in place of its
/// amplitude b.
void set_acceleration(const TomlTable& t, double gamma, Scene& scene) {
    if (!scene.plates.bottom || scene.gravity == 0 ||
        !t.table("plates").table("bottom").has("period")) {
        throw t.error("gamma", "needs more", fmt::format("{:g}", gamma),
                      "gravity and a bottom plate with a period");
    }
    auto& bottom = *scene.plates.bottom;
    if (bottom.amplitude != 0) {
        throw t.error("gamma", "contradicts", "the amplitude of 'plates.bottom' as well",
                      "one of the two", "remove one");
    }
    const double omega = 2 * std::numbers::pi / bottom.period;
    bottom.amplitude = gamma * scene.gravity / (omega * omega);
}

std::vector<double> time_steps(const TomlTable& t, double t_col) {
    if (exactly_one(t, {"dt", "steps_per_contact_time"}) == "dt") {
        return t.numbers("dt", Range::positive());
    }
    std::vector<double> steps = t.numbers("steps_per_contact_time", Range::positive());
    for (double& value : steps)
        value = t_col / value;
    return steps;
}

/// A length of time and the key that gave it.
struct Duration {
    std::string key;
    double time = 0;
};

/// Given in contact times or in time units, under one of two keys.
Duration duration(const TomlTable& t, double t_col, const std::string& in_time,
                  const std::string& in_contact_times) {
    const std::string key = exactly_one(t, {in_time, in_contact_times});
    return {key, t.number(key, Range::positive()) * (key == in_time ? 1.0 : t_col)};
}

/// Whole number of steps nearest to a duration; within round-off of a half it does not matter.
std::int64_t steps_in(const TomlTable& t, const Duration& duration, double dt) {
    const double steps = std::round(duration.time / dt);
    if (!(steps >= 1)) {
        throw t.error(duration.key, "is shorter than a time step",
                      fmt::format("{:g}", duration.time), fmt::format("at least dt = {:g}", dt));
    }
    if (steps > static_cast<double>(most_steps)) {
        throw t.error(duration.key, "is too long", fmt::format("{:g} steps", steps),
                      fmt::format("at most {} steps", most_steps));
    }
    return static_cast<std::int64_t>(steps);
}

void read_schedule(const TomlTable& t, double t_col, Scene& scene) {
    scene.steps = steps_in(t, duration(t, t_col, "time", "contact_times"), scene.dt);
    const TomlTable frames = t.table("frames");
    if (frames.has("first_and_last") && frames.boolean("first_and_last")) {
        scene.frame_every = scene.steps;
        for (const char* key : {"every_time", "every_contact_times", "every_steps"}) {
            if (frames.has(key)) {
                throw frames.error(key, "contradicts", "'first_and_last' as well", "one of the two",
                                   "remove one");
            }
        }
    } else {
        const std::string key =
            exactly_one(frames, {"every_time", "every_contact_times", "every_steps"});
        scene.frame_every =
            key == "every_steps"
                ? frames.integer(key, 1)
                : steps_in(frames, duration(frames, t_col, "every_time", "every_contact_times"),
                           scene.dt);
        if (scene.frame_every > scene.steps) {
            throw frames.error(key, "is longer than the run",
                               fmt::format("{} steps", scene.frame_every),
                               fmt::format("at most {} steps", scene.steps));
        }
    }
    frames.reject_unknown_keys();
    // The last frame is the end of the run.
    const std::int64_t intervals = (scene.steps - 1) / scene.frame_every + 1;
    if (intervals >= most_frames) {
        throw t.error("frames", "makes too many frames", fmt::format("{}", intervals + 1),
                      fmt::format("at most {}", most_frames), "take frames less often");
    }
    scene.steps = intervals * scene.frame_every;
}

/// No longer than grains may be apart.
void check_period(const TomlTable& t, const char* key, const std::optional<double>& period,
                  double diameter) {
    const double most = 2 * farthest * diameter;
    if (!period || *period <= most) return;
    throw t.error(key, "is too long", fmt::format("{:g}", *period),
                  fmt::format("at most {:g} diameters, {:g}", 2 * farthest, most),
                  "leave it out for a scene that is open");
}

void check_consistency(const TomlTable& t, const Scene& scene) {
    check_period(t, "periodic_x", scene.periodic_x, scene.grains.diameter);
    check_period(t, "periodic_y", scene.periodic_y, scene.grains.diameter);
    const bool has_plate =
        scene.plates.bottom || !std::holds_alternative<std::monostate>(scene.plates.lid);
    if (scene.periodic_y && has_plate) {
        throw t.error("periodic_y", "contradicts", "plates as well", "a period along y or plates",
                      "remove one");
    }
    if (scene.backing && scene.periodic_x) {
        throw t.error("backing", "contradicts", "'periodic_x' as well",
                      "planes across x or a period along x", "remove one");
    }
    if (!std::isfinite(contact_time(scene))) {
        throw t.error("contact", "is overdamped", fmt::format("eta = {:g}", scene.contact.damping),
                      "2 k/m > (eta/m)^2, so that a collision ends");
    }
}

}  // namespace

std::size_t ladder_size(const TomlTable& t) {
    return t.numbers(exactly_one(t, {"dt", "steps_per_contact_time"}), Range::positive()).size();
}

Scene read_scene(const TomlTable& t, const SceneSelection& selection) {
    Scene scene;
    scene.name = selection.name;
    scene.seed = selection.seed;
    const TomlTable grains = t.table("grains");
    scene.grains = read_grains(grains);
    const SizeSpread sizes = read_sizes(grains);
    scene.contact = read_contact(t.table("contact"), scene.grains.mass);
    if (t.has("plates")) {
        scene.plates = read_plates(t.table("plates"), scene.contact.stiffness);
    }
    scene.gravity = t.number("gravity", Range::not_negative());
    if (const auto gamma = t.optional_number("gamma", Range::positive())) {
        set_acceleration(t, *gamma, scene);
    }
    scene.drag = t.optional_number("drag", Range::not_negative()).value_or(0);
    if (t.has("backing")) {
        scene.backing = read_backing(t.table("backing"), scene.contact.stiffness);
    }
    scene.periodic_x = t.optional_number("periodic_x", Range::positive());
    scene.periodic_y = t.optional_number("periodic_y", Range::positive());
    scene.integrator = static_cast<Integrator>(t.choice("integrator", integrator_words));
    if (t.has("contacts")) {
        scene.contacts = static_cast<Contacts>(t.choice("contacts", contacts_words));
    }
    if (t.has("precision")) {
        scene.precision = static_cast<Precision>(t.choice("precision", precision_words));
    }
    scene.skin = t.optional_number("skin", Range::positive());
    check_consistency(t, scene);
    const double t_col = contact_time(scene);
    scene.dt = time_steps(t, t_col).at(selection.rung);
    read_schedule(t, t_col, scene);
    const InitialStateRecipe recipe = read_initial_state(t.table("initial"));
    t.reject_unknown_keys();
    try {
        generate_initial_state(scene, recipe, sizes);
    } catch (const std::invalid_argument& error) {
        throw t.error("initial", "cannot be made", error.what(),
                      "grains apart from each other, of a number that is within bounds");
    }
    return scene;
}

}  // namespace crossgrain::scene
