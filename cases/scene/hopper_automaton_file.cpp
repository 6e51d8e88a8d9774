#include "cases/scene/limits.hpp"
#include "cases/scene/model_file.hpp"
#include "native/base/memory_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace crossgrain::scene {
namespace {

using toml_input::Range;
using toml_input::TomlTable;

const std::array<std::string, 2> sweep_words{"bottom-to-top", "top-to-bottom"};
const std::array<std::string, 2> rows_words{"half-levels", "zigzag"};
const std::array<std::string, 2> inertia_words{"source-orientation", "literal"};
const std::array<std::string, 2> random_words{"per-site", "shared-stream"};
const std::array<std::string, 2> engine_words{"fast", "plain"};

/// The reading that reproduces the paper, and those that do not, each with one choice changed.
std::vector<HopperReading> named_readings() {
    return {{.name = "standard"},
            {.name = "zigzag", .rows = HopperRows::zigzag},
            {.name = "top-to-bottom", .sweep = HopperSweep::top_to_bottom},
            {.name = "literal-inertia", .inertia = HopperInertia::literal},
            {.name = "no-rotation", .rotation = false},
            {.name = "strict-ties", .tie_tolerance = 1e-9}};
}

HopperReading read_named(const TomlTable& t) {
    const std::vector<HopperReading> readings = named_readings();
    if (!t.has("reading")) return readings.front();
    std::vector<std::string> names;
    for (const auto& reading : readings)
        names.push_back(reading.name);
    return readings[t.choice("reading", names)];
}

HopperReading read_reading(const TomlTable& t) {
    HopperReading reading = read_named(t);
    bool changed = false;
    const auto given = [&](const char* key) {
        const bool here = t.has(key);
        changed = changed || here;
        return here;
    };
    if (given("sweep")) reading.sweep = static_cast<HopperSweep>(t.choice("sweep", sweep_words));
    if (given("rows")) reading.rows = static_cast<HopperRows>(t.choice("rows", rows_words));
    if (given("inertia")) {
        reading.inertia = static_cast<HopperInertia>(t.choice("inertia", inertia_words));
    }
    if (given("rotation")) reading.rotation = t.boolean("rotation");
    if (given("tie_tolerance")) {
        reading.tie_tolerance = t.number("tie_tolerance", Range::not_negative());
    }
    if (changed) reading.name += ", changed";
    return reading;
}

/// Full opening angles in degrees.
Range angle_range() {
    return {0, std::nextafter(180.0, 0.0), true, "an angle in (0, 180) degrees"};
}

std::vector<double> read_angle_sweep(const TomlTable& t) {
    constexpr double most = 100'000;
    const double from = t.number("from", angle_range());
    const double to = t.number("to", angle_range());
    const double step = t.number("step", Range::positive());
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

std::vector<double> read_angles(const TomlTable& t) {
    if (t.has("slope")) {
        if (t.has("angles")) {
            throw t.error("slope", "contradicts", "'scene.angles' as well", "one of the two",
                          "remove one");
        }
        const double slope = t.number("slope", Range::positive());
        return {2 * std::atan(1 / slope) * 180 / std::numbers::pi};
    }
    if (!t.has("angles")) {
        throw t.missing("angles", "full opening angles in degrees, or 'slope' of the walls");
    }
    return t.is_table("angles") ? read_angle_sweep(t.table("angles"))
                                : t.numbers("angles", angle_range());
}

int read_count(const TomlTable& t, const char* key, std::int64_t least, std::int64_t most) {
    return static_cast<int>(t.integer(key, least, most));
}

int optional_count(const TomlTable& t, const char* key, std::int64_t least, std::int64_t most,
                   int standard) {
    return t.has(key) ? read_count(t, key, least, most) : standard;
}

/// A level k has N - 1 + k tan(theta/2)/sqrt(3) sites, more or less one.
void check_size(const TomlTable& t, const HopperAutomaton& scene) {
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
void check_runs(const TomlTable& t, const HopperAutomaton& scene) {
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

void check_tie_tolerance(const TomlTable& t, const HopperAutomaton& scene) {
    const double largest = largest_difference(scene);
    // Without any energy all candidates are equal whatever the tolerance: the model's null case.
    if (largest == 0 || scene.reading.tie_tolerance < largest) return;
    throw t.error("tie_tolerance", "makes all candidates equal",
                  fmt::format("{:g}", scene.reading.tie_tolerance),
                  fmt::format("less than {:g}, the largest difference of energies for these "
                              "coefficients",
                              largest));
}

void read_schedule(const TomlTable& t, HopperAutomaton& scene) {
    constexpr std::int64_t most = 1'000'000'000;
    scene.iterations = read_count(t, "iterations", 1, most);
    scene.every = t.has("every") ? t.integer("every", 1) : scene.iterations;
    if (scene.every > scene.iterations) {
        throw t.error("every", "is longer than the run", fmt::format("{}", scene.every),
                      fmt::format("at most {} iterations", scene.iterations));
    }
}

}  // namespace

HopperAutomaton read_hopper_automaton(const TomlTable& t, const SceneSelection& selection) {
    constexpr std::int64_t most = 1'000'000;
    HopperAutomaton scene{.name = selection.name, .seed = selection.seed};
    scene.reading = read_reading(t);
    scene.outlet = read_count(t, "outlet", 2, most);
    scene.levels = read_count(t, "levels", 1, most);
    scene.angles = read_angles(t);
    scene.c_d = t.number("c_d", Range::not_negative());
    scene.c_o = t.number("c_o", Range::not_negative());
    scene.c_i = t.number("c_i", Range::not_negative());
    scene.c_w = t.number("c_w", Range::not_negative());
    read_schedule(t, scene);
    scene.replicas = optional_count(t, "replicas", 1, most, 1);
    scene.flipped = optional_count(t, "flipped", 0, most, 0);
    if (t.has("random")) {
        scene.random = static_cast<HopperRandom>(t.choice("random", random_words));
    }
    if (t.has("engine")) {
        scene.engine = static_cast<HopperEngine>(t.choice("engine", engine_words));
    }
    t.reject_unknown_keys();
    check_size(t, scene);
    check_runs(t, scene);
    check_tie_tolerance(t, scene);
    return scene;
}

}  // namespace crossgrain::scene
