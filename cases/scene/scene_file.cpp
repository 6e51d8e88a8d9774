#include "cases/scene/scene_file.hpp"

#include "cases/scene/contact_file.hpp"
#include "cases/scene/initial_state_file.hpp"
#include "cases/scene/limits.hpp"
#include "cases/scene/plates_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace crossgrain::scene {
namespace {

using toml_input::ChoiceRule;
using toml_input::KeyedTable;
using toml_input::NumberRule;
using toml_input::NumbersRule;
using toml_input::OneOf;
using toml_input::Range;
using toml_input::TableKeys;
using toml_input::TableRule;
using enum toml_input::Need;

const TableKeys& grains_keys() {
    static const TableKeys keys{
        .name = "grains",
        .keys = {{"diameter", NumberRule{Range::positive()}, "nominal diameter d", required},
                 {"mass", NumberRule{Range::positive()}, "of a grain of that diameter", required},
                 {"diameter_spread",
                  NumberRule{{.low = 0,
                              .high = 1,
                              .high_open = true,
                              .text = "a number in [0, 1): 0.05 is 5 % to either side"}},
                  "share by which diameters differ to either side, default 0"},
                 {"mass_exponent", NumberRule{Range::not_negative()},
                  "masses grow with this power of the diameter"}}};
    return keys;
}

const TableKeys& backing_keys() {
    static const TableKeys keys{
        .name = "backing",
        .keys = {{"stiffness", NumberRule{Range::positive()}, "left out: the contact's"},
                 {"left", NumberRule{Range::any()}, "x of the left plane", required},
                 {"right", NumberRule{Range::any()}, "x of the right plane, > left", required}}};
    return keys;
}

const TableKeys& frames_keys() {
    static const TableKeys keys{
        .name = "frames",
        .keys = {{"every_time", NumberRule{Range::positive()}, "time between frames"},
                 {"every_contact_times", NumberRule{Range::positive()},
                  "the same in contact times"},
                 {"every_steps", toml_input::IntegerRule{1}, "the same in time steps"},
                 {"first_and_last", toml_input::BooleanRule{}, "only these two frames"}},
        .groups = {OneOf{{"every_time", "every_contact_times", "every_steps"}, false}}};
    return keys;
}

Grains read_grains(const KeyedTable& t) {
    return {.diameter = t.number("diameter"), .mass = t.number("mass")};
}

SizeSpread read_sizes(const KeyedTable& t) {
    SizeSpread sizes;
    sizes.spread = t.optional_number("diameter_spread").value_or(sizes.spread);
    sizes.mass_exponent = t.optional_number("mass_exponent").value_or(sizes.mass_exponent);
    t.reject_unknown_keys();
    return sizes;
}

BackingPlanes read_backing(const KeyedTable& t, double contact_stiffness) {
    const BackingPlanes planes{.stiffness =
                                   t.optional_number("stiffness").value_or(contact_stiffness),
                               .left = t.number("left"),
                               .right = t.number("right")};
    if (planes.left >= planes.right) {
        throw t.error("right", "is out of range", fmt::format("{:g}", planes.right),
                      fmt::format("a number > left = {:g}", planes.left));
    }
    t.reject_unknown_keys();
    return planes;
}

/// Gamma = b omega_0^2/g: the bottom's largest acceleration in units of gravity, in place of its
/// amplitude b.
void set_acceleration(const KeyedTable& t, double gamma, Scene& scene) {
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

std::vector<double> time_steps(const KeyedTable& t, double t_col) {
    if (t.exactly_one("dt") == "dt") {
        return t.numbers("dt");
    }
    std::vector<double> steps = t.numbers("steps_per_contact_time");
    for (double& value : steps)
        value = t_col / value;
    return steps;
}

/// A length of time and the key that gave it.
struct Duration {
    std::string key;
    double time = 0;
};

/// Given in time units, under `in_time`, or in contact times, under the other key of its group.
Duration duration(const KeyedTable& t, double t_col, const std::string& in_time) {
    const std::string key = t.exactly_one(in_time);
    return {key, t.number(key) * (key == in_time ? 1.0 : t_col)};
}

/// Whole number of steps nearest to a duration; within round-off of a half it does not matter.
std::int64_t steps_in(const KeyedTable& t, const Duration& duration, double dt) {
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

void read_schedule(const KeyedTable& t, double t_col, Scene& scene) {
    scene.steps = steps_in(t, duration(t, t_col, "time"), scene.dt);
    const KeyedTable frames = t.table("frames");
    if (frames.has("first_and_last") && frames.boolean("first_and_last")) {
        scene.frame_every = scene.steps;
        for (const char* key : {"every_time", "every_contact_times", "every_steps"}) {
            if (frames.has(key)) {
                throw frames.error(key, "contradicts", "'first_and_last' as well", "one of the two",
                                   "remove one");
            }
        }
    } else {
        const std::string key = frames.exactly_one("every_time");
        scene.frame_every = key == "every_steps"
                                ? frames.integer(key)
                                : steps_in(frames, duration(frames, t_col, "every_time"), scene.dt);
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
void check_period(const KeyedTable& t, const char* key, const std::optional<double>& period,
                  const Grains& grains) {
    if (!period) return;
    const double most = 2 * farthest * grains.diameter;
    const double widest = largest_diameter(grains);
    if (*period < widest) {
        throw t.error(key, "is too short", fmt::format("{:g}", *period),
                      fmt::format("at least the largest diameter, {:g}", widest),
                      "a grain must not overlap with its own image");
    }
    if (*period <= most) return;
    throw t.error(key, "is too long", fmt::format("{:g}", *period),
                  fmt::format("at most {:g} diameters, {:g}", 2 * farthest, most),
                  "leave it out for a scene that is open");
}

void check_consistency(const KeyedTable& t, const Scene& scene) {
    check_period(t, "periodic_x", scene.periodic_x, scene.grains);
    check_period(t, "periodic_y", scene.periodic_y, scene.grains);
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

const TableKeys& scene_keys() {
    static const TableKeys keys{
        .name = "scene",
        .keys =
            {{"grains", TableRule{grains_keys}, "sizes and masses", required},
             {"contact", TableRule{contact_keys}, "forces between grains that touch", required},
             {"plates", TableRule{plates_keys}, "a bottom and a lid; left out: none"},
             {"backing", TableRule{backing_keys}, "elastic planes across x; left out: none"},
             {"gravity", NumberRule{Range::not_negative()}, "along -y", required},
             {"gamma", NumberRule{Range::positive()},
              "largest acceleration of the bottom plate in units of gravity, sets its amplitude"},
             {"drag", NumberRule{Range::not_negative()}, "force -drag v on a grain, default 0"},
             {"periodic_x", NumberRule{Range::positive()}, "length; left out: open"},
             {"periodic_y", NumberRule{Range::positive()}, "length; left out: open"},
             {"integrator", ChoiceRule{all_words<Integrator>()},
              "how motion is integrated; foreign codes know \"verlet-half-step\"", required},
             {"contacts", ChoiceRule{all_words<Contacts>()},
              "where contacts are looked for, default \"neighbour-list\""},
             {"precision", ChoiceRule{all_words<Precision>()}, "default \"double\""},
             {"skin", NumberRule{Range::positive()}, "of neighbour lists; left out: chosen"},
             {"dt", NumbersRule{Range::positive()}, "time step, or a ladder of them"},
             {"steps_per_contact_time", NumbersRule{Range::positive()},
              "the same in steps per contact time"},
             {"time", NumberRule{Range::positive()}, "length of the run"},
             {"contact_times", NumberRule{Range::positive()}, "the same in contact times"},
             {"frames", TableRule{frames_keys}, "when the state is looked at", required},
             {"initial", TableRule{initial_keys}, "where grains start", required}},
        .groups = {OneOf{{"dt", "steps_per_contact_time"}}, OneOf{{"time", "contact_times"}}}};
    return keys;
}

std::size_t ladder_size(const toml_input::TomlTable& table) {
    const KeyedTable t(table, scene_keys());
    return t.numbers(t.exactly_one("dt")).size();
}

Scene read_scene(const toml_input::TomlTable& table, const SceneSelection& selection) {
    const KeyedTable t(table, scene_keys());
    Scene scene;
    scene.name = selection.name;
    scene.seed = selection.seed;
    const KeyedTable grains = t.table("grains");
    scene.grains = read_grains(grains);
    const SizeSpread sizes = read_sizes(grains);
    scene.contact = read_contact(t.table("contact"), scene.grains.mass);
    if (t.has("plates")) {
        scene.plates = read_plates(t.table("plates"), scene.contact.stiffness);
    }
    scene.gravity = t.number("gravity");
    if (const auto gamma = t.optional_number("gamma")) {
        set_acceleration(t, *gamma, scene);
    }
    scene.drag = t.optional_number("drag").value_or(0);
    if (t.has("backing")) {
        scene.backing = read_backing(t.table("backing"), scene.contact.stiffness);
    }
    scene.periodic_x = t.optional_number("periodic_x");
    scene.periodic_y = t.optional_number("periodic_y");
    scene.integrator = t.choice<Integrator>("integrator");
    if (t.has("contacts")) {
        scene.contacts = t.choice<Contacts>("contacts");
    }
    if (t.has("precision")) {
        scene.precision = t.choice<Precision>("precision");
    }
    scene.skin = t.optional_number("skin");
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
