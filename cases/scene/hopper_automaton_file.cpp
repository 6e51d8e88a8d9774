#include "cases/scene/limits.hpp"
#include "cases/scene/model_file.hpp"
#include "native/base/memory_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace crossgrain::scene {
namespace {

using toml_input::ChoiceRule;
using toml_input::IntegerRule;
using toml_input::KeyedTable;
using toml_input::NumberRule;
using toml_input::NumbersRule;
using toml_input::Range;
using toml_input::TableKeys;
using enum toml_input::Need;

constexpr std::int64_t largest_count = 1'000'000, most_iterations = 1'000'000'000;

/// The reading that reproduces the paper, and those that do not, each with one choice changed.
std::vector<HopperReading> named_readings() {
    return {{.name = "standard"},
            {.name = "zigzag", .rows = HopperRows::zigzag},
            {.name = "top-to-bottom", .sweep = HopperSweep::top_to_bottom},
            {.name = "literal-inertia", .inertia = HopperInertia::literal},
            {.name = "no-rotation", .rotation = false},
            {.name = "strict-ties", .tie_tolerance = 1e-9}};
}

HopperReading read_named(const KeyedTable& t) {
    const std::vector<HopperReading> readings = named_readings();
    return t.has("reading") ? readings[t.choice("reading")] : readings.front();
}

HopperReading read_reading(const KeyedTable& t) {
    HopperReading reading = read_named(t);
    bool changed = false;
    const auto given = [&](const char* key) {
        const bool here = t.has(key);
        changed = changed || here;
        return here;
    };
    if (given("sweep")) reading.sweep = t.choice<HopperSweep>("sweep");
    if (given("rows")) reading.rows = t.choice<HopperRows>("rows");
    if (given("inertia")) {
        reading.inertia = t.choice<HopperInertia>("inertia");
    }
    if (given("rotation")) reading.rotation = t.boolean("rotation");
    if (given("tie_tolerance")) {
        reading.tie_tolerance = t.number("tie_tolerance");
    }
    if (changed) reading.name += ", changed";
    return reading;
}

/// Full opening angles in degrees.
Range angle_range() {
    return {0, 180, true, true, "an angle in (0, 180) degrees"};
}

const TableKeys& angle_sweep_keys() {
    static const TableKeys keys{
        .name = "angles",
        .keys = {{"from", NumberRule{angle_range()}, "degrees", required},
                 {"to", NumberRule{angle_range()}, "degrees, included", required},
                 {"step", NumberRule{Range::positive()}, "degrees", required}}};
    return keys;
}

std::vector<double> read_angle_sweep(const KeyedTable& t) {
    constexpr double most = 100'000;
    const double from = t.number("from");
    const double to = t.number("to");
    const double step = t.number("step");
    t.reject_unknown_keys();
    if (to < from) {
        throw t.error("to", "is below 'from'", fmt::format("{:g}", to),
                      fmt::format("at least {:g}", from));
    }
    // The last angle is `to` also where step has no finite binary fraction.
    const double intervals = std::floor((to - from) / step * (1 + 1e-12) + 1e-9);
    if (intervals >= most) {
        throw t.error("step", "is too small", fmt::format("{:g}", step),
                      fmt::format("at most {:g} angles", most));
    }
    std::vector<double> angles;
    for (double i = 0; i <= intervals; ++i)
        angles.push_back(std::min(from + i * step, to));
    return angles;
}

std::vector<double> read_angles(const KeyedTable& t) {
    if (t.exactly_one("angles") == "slope") {
        const double slope = t.number("slope");
        return {2 * std::atan(1 / slope) * 180 / std::numbers::pi};
    }
    return t.is_table("angles") ? read_angle_sweep(t.table("angles")) : t.numbers("angles");
}

int read_count(const KeyedTable& t, const char* key) {
    return static_cast<int>(t.integer(key));
}

int optional_count(const KeyedTable& t, const char* key, int standard) {
    return t.has(key) ? read_count(t, key) : standard;
}

/// A level k has N - 1 + k tan(theta/2)/sqrt(3) sites, more or less one.
void check_size(const KeyedTable& t, const HopperAutomaton& scene) {
    constexpr double most = 1e8;  // a few bytes each, in a run and its twin
    for (const double angle : scene.angles) {
        const double levels = scene.levels;
        const double widening = std::tan(angle * std::numbers::pi / 360) / std::sqrt(3.0);
        const double sites = levels * scene.outlet + levels * levels * widening / 2;
        if (sites > most) {
            throw t.error("levels", "makes too large a hopper",
                          fmt::format("about {:.3g} sites at {:g} degrees", sites, angle),
                          fmt::format("at most {:g} sites", most),
                          "fewer levels or smaller angles");
        }
    }
}

/// Each run (an angle's replica) has random numbers of its own, counted in 32 bits, and keeps what
/// left it in every iteration; what is measured keeps some numbers of every frame.
void check_runs(const KeyedTable& t, const HopperAutomaton& scene) {
    const double runs = static_cast<double>(scene.angles.size()) * scene.replicas;
    const double flow = 8.0 * static_cast<double>(scene.iterations);
    const double frames =
        runs * (static_cast<double>(scene.iterations) / static_cast<double>(scene.every) + 2);
    constexpr double most = 1e7;
    if (runs > most) {
        throw t.error("replicas", "makes too many runs",
                      fmt::format("{:g} angles and replicas", runs),
                      fmt::format("at most {:g}", most));
    }
    if (flow > memory_budget()) {
        throw t.error("iterations", "is too many to keep what flows out in each", shown_bytes(flow),
                      fmt::format("at most {}", shown_bytes(memory_budget())));
    }
    if (frames > static_cast<double>(most_frames)) {
        throw t.error("every", "makes too many frames",
                      fmt::format("{:.6g} in all angles and replicas", frames),
                      fmt::format("at most {}", most_frames), "take frames less often");
    }
}

/// The largest difference of energy that two candidates can have: five neighbours beside the
/// source, or four and the wall; orientations 1 and 3, sources 2 and 4.
double largest_difference(const HopperAutomaton& s) {
    return std::max(5 * s.c_d, 4 * s.c_d + s.c_w) + 2 * s.c_o + 2 * s.c_i;
}

void check_tie_tolerance(const KeyedTable& t, const HopperAutomaton& scene) {
    const double largest = largest_difference(scene);
    // Without any energy all candidates are equal whatever the tolerance: the model's null case.
    if (largest == 0 || scene.reading.tie_tolerance < largest) return;
    throw t.error("tie_tolerance", "makes all candidates equal",
                  fmt::format("{:g}", scene.reading.tie_tolerance),
                  fmt::format("less than {:g}, the largest difference of energies for these "
                              "coefficients",
                              largest));
}

void read_schedule(const KeyedTable& t, HopperAutomaton& scene) {
    scene.iterations = read_count(t, "iterations");
    scene.every = t.has("every") ? t.integer("every") : scene.iterations;
    if (scene.every > scene.iterations) {
        throw t.error("every", "is longer than the run", fmt::format("{}", scene.every),
                      fmt::format("at most {} iterations", scene.iterations));
    }
}

}  // namespace

const TableKeys& hopper_automaton_keys() {
    static const NumberRule coefficient{Range::not_negative()};
    static const TableKeys keys = [] {
        std::vector<std::string> readings;
        for (const auto& reading : named_readings())
            readings.push_back(reading.name);
        return TableKeys{
            .name = "scene",
            .keys = {{"outlet", IntegerRule{2, largest_count}, "N in sites", required},
                     {"levels", IntegerRule{1, largest_count}, "L", required},
                     {"angles",
                      {NumbersRule{angle_range()}, toml_input::TableRule{angle_sweep_keys}},
                      "full opening angles in degrees"},
                     {"slope", NumberRule{Range::positive()},
                      "of the walls: tan(theta/2) = 1/slope"},
                     {"c_d", coefficient, "C_D, of density", required},
                     {"c_o", coefficient, "C_O, of orientation", required},
                     {"c_i", coefficient, "C_I, of inertia", required},
                     {"c_w", coefficient, "C_W, of walls", required},
                     {"iterations", IntegerRule{1, most_iterations}, "of the run", required},
                     {"every", IntegerRule{1}, "iterations between frames; left out: all of them"},
                     {"replicas", IntegerRule{1, largest_count}, "per angle, default 1"},
                     {"flipped", IntegerRule{0, largest_count},
                      "nodes flipped in a twin, default 0"},
                     {"random", ChoiceRule{all_words<HopperRandom>()}, "default \"per-site\""},
                     {"engine", ChoiceRule{all_words<HopperEngine>()},
                      "default \"fast\"; the same bits"},
                     {"reading", ChoiceRule{readings}, "of the rules, default \"standard\""},
                     {"sweep", ChoiceRule{all_words<HopperSweep>()}, "order of the levels"},
                     {"rows", ChoiceRule{all_words<HopperRows>()}, "which sites make a row"},
                     {"inertia", ChoiceRule{all_words<HopperInertia>()}, "reading of inertia"},
                     {"rotation", toml_input::BooleanRule{}, "whether grains turn"},
                     {"tie_tolerance", coefficient, "energies closer than this are equal"}},
            .groups = {toml_input::OneOf{{"angles", "slope"}}}};
    }();
    return keys;
}

HopperAutomaton read_hopper_automaton(const toml_input::TomlTable& table,
                                      const SceneSelection& selection) {
    const KeyedTable t(table, hopper_automaton_keys());
    HopperAutomaton scene{.name = selection.name, .seed = selection.seed};
    scene.reading = read_reading(t);
    scene.outlet = read_count(t, "outlet");
    scene.levels = read_count(t, "levels");
    scene.angles = read_angles(t);
    scene.c_d = t.number("c_d");
    scene.c_o = t.number("c_o");
    scene.c_i = t.number("c_i");
    scene.c_w = t.number("c_w");
    read_schedule(t, scene);
    scene.replicas = optional_count(t, "replicas", 1);
    scene.flipped = optional_count(t, "flipped", 0);
    if (t.has("random")) {
        scene.random = t.choice<HopperRandom>("random");
    }
    if (t.has("engine")) {
        scene.engine = t.choice<HopperEngine>("engine");
    }
    t.reject_unknown_keys();
    check_size(t, scene);
    check_runs(t, scene);
    check_tie_tolerance(t, scene);
    return scene;
}

}  // namespace crossgrain::scene
