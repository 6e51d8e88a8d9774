// crossgrain bench dem-friction: rotating grains with friction in a dilute pipe and in a dense
// hopper, from the same state on, native and in the other codes, each in the conventions of its own
// law. What is compared is CPU seconds per step of a mobile grain; contenders take turns, and the
// fastest of several turns counts (the median is told). The time of a short run is taken off that
// of a long one: what is left is steps.
#include "adapters/lammps/lammps_code.hpp"
#include "adapters/liggghts/liggghts_code.hpp"
#include "adapters/native/friction_scene.hpp"
#include "adapters/native/native_dem_code.hpp"
#include "adapters/yade/yade_code.hpp"
#include "app/bench.hpp"
#include "native/base/errors.hpp"
#include "native/base/random.hpp"
#include "native/friction/engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <unistd.h>
#include <utility>

namespace crossgrain::app {
namespace {

namespace fs = std::filesystem;

/// Units d = m = g = 1. Head-on collisions of two grains of unit mass have this restitution and
/// contact time.
scene::Scene empty_scene(std::string name, double restitution, double contact_time) {
    const double rate = -std::log(restitution) / contact_time;
    const double omega = std::numbers::pi / contact_time;
    scene::Scene s{.name = std::move(name), .grains = {.diameter = 1, .mass = 1}};
    s.contact.stiffness = (omega * omega + rate * rate) / 2;
    s.contact.damping = rate;
    s.contact.damping_acts_on = scene::Damping::normal_only;
    s.contact.clipping = scene::Clipping::normal_only;
    s.contact.spins = scene::Spins::on;
    s.contact.friction =
        scene::Friction{.coefficient = 0.5, .stiffness = s.contact.stiffness * 2 / 7};
    s.gravity = 1;
    s.dt = contact_time / 20;
    return s;
}

void add(scene::Scene& s, double x, double y, double vx, double vy, double diameter, bool frozen) {
    s.initial.x.push_back(x);
    s.initial.y.push_back(y);
    s.initial.vx.push_back(vx);
    s.initial.vy.push_back(vy);
    s.initial.omega.push_back(0);
    s.initial.frozen.push_back(frozen);
    s.grains.diameters.push_back(diameter);
    s.grains.masses.push_back(diameter * diameter * diameter);
}

double diameter_within(double spread, std::uint64_t grain) {
    return 1 + spread * (2 * uniform(1, RandomStream::jitter, grain) - 1);
}

/// Lets the native engine run the scene for a time; optionally without its first grains after it.
scene::Scene evolved(scene::Scene s, double time, std::size_t removed = 0) {
    friction::Engine engine(adapters::friction_parameters(s), adapters::friction_initial_state(s));
    engine.advance(std::lround(time / s.dt));
    const auto& now = engine.state();
    s.initial.x = now.x, s.initial.y = now.y;
    s.initial.vx = now.vx, s.initial.vy = now.vy;
    s.initial.omega = now.omega;
    const auto drop = [&](auto& values) {
        values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(removed));
    };
    for (auto* values : {&s.initial.x, &s.initial.y, &s.initial.vx, &s.initial.vy, &s.initial.omega,
                         &s.grains.diameters, &s.grains.masses})
        drop(*values);
    drop(s.initial.frozen);
    return s;
}

/// 420 grains between two rows of staggered frozen discs, phi = 0.15, with the waves that come by
/// themselves.
scene::Scene pipe() {
    constexpr double length = 220;
    constexpr std::uint64_t grains = 420, wall = 137;
    auto s = empty_scene("bench/pipe", 0.8, 0.025);
    s.periodic_y = length;
    s.backing = scene::BackingPlanes{.stiffness = s.contact.stiffness, .left = 0, .right = 11};
    for (std::uint64_t k = 0; k < wall; ++k) {
        const double spacing = length / wall;
        add(s, 0, spacing * static_cast<double>(k), 0, 0, 1, true);
        add(s, 11, spacing * (static_cast<double>(k) + 0.5), 0, 0, 1, true);
    }
    for (std::uint64_t i = 0; i < grains; ++i) {
        const auto v = normal_pair(1, RandomStream::initial_velocity, i);
        add(s, 1.5 + 1.6 * static_cast<double>(i % 6), 0.5 + 3.14 * static_cast<double>(i / 6),
            5 * v[0], 5 * v[1] - 8, diameter_within(0.05, i), false);
    }
    return evolved(std::move(s), 50);
}

/// A filling that has settled behind a plug and has begun to flow: outlet 20, walls of touching
/// discs at 30 degrees to the vertical.
scene::Scene hopper(double height) {
    constexpr double outlet = 20, angle = std::numbers::pi / 6, spacing = 1.25;
    auto s = empty_scene("bench/hopper", 0.5, 0.0228);
    std::size_t plug = 0;
    for (; plug < static_cast<std::size_t>(outlet); ++plug)
        add(s, static_cast<double>(plug) + 0.5 - outlet / 2, -0.5, 0, 0, 1, true);
    for (double along = 0; along < 1.25 * height / std::cos(angle); along += 1) {
        for (const double side : {-1.0, 1.0}) {
            add(s, side * (outlet / 2 + 0.5 + along * std::sin(angle)), along * std::cos(angle), 0,
                0, 1, true);
        }
    }
    std::uint64_t i = 0;
    for (double y = 1; y < 1.1 * height; y += spacing) {
        const double half = outlet / 2 + y * std::tan(angle) - 1.2;
        for (double x = -half; x < half; x += spacing, ++i) {
            const auto v = normal_pair(1, RandomStream::initial_velocity, i);
            add(s, x, y, 0.1 * v[0], 0.1 * v[1], diameter_within(0.2, i), false);
        }
    }
    return evolved(evolved(std::move(s), 20, plug), 3);
}

std::size_t mobile_grains(const scene::Scene& s) {
    return static_cast<std::size_t>(
        std::count(s.initial.frozen.begin(), s.initial.frozen.end(), false));
}

/// A directory that goes with the object.
class Scratch {
  public:
    Scratch() {
        std::string name = (fs::temp_directory_path() / "crossgrain-bench-XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no temporary directory: " + name);
        path_ = name;
    }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

struct Contender {
    std::string name;
    const adapters::GrainCode* code = nullptr;
    const char* conventions = nullptr;  ///< see scene::conventions_named
    /// Of dashpots: some laws know only this one.
    scene::DampingScale scale = scene::DampingScale::absolute;
    double share = 1;                 ///< of the steps of the native engine that it is given
    std::vector<double> skins = {};   ///< to try in the first turn; empty: the code's own
    double skin = 0;                  ///< the best of them
    std::vector<double> starts = {};  ///< CPU seconds of a tenth of the steps, turn after turn
    std::vector<double> runs = {};    ///< of that and all of them
    std::int64_t steps = 0;
};

/// The code's own input with another skin, which a later `neighbor` command sets.
std::vector<adapters::InputFile> with_skin(std::vector<adapters::InputFile> files, double skin) {
    for (auto& file : files) {
        if (const auto run = file.text.rfind("\nrun "); file.name.starts_with("in."))
            file.text.insert(run, fmt::format("\nneighbor {:.3g} bin", skin));
    }
    return files;
}

/// The scene in the words of the contender's law; for unit masses all are the same.
scene::Scene asked_of(const Contender& contender, scene::Scene s, std::int64_t steps) {
    s.steps = s.frame_every = steps;
    s.contact.friction->conventions = scene::conventions_named(contender.conventions);
    s.contact.damping_scale = contender.scale;
    // Per unit of the effective mass, 1/2.
    if (contender.scale == scene::DampingScale::effective_mass) s.contact.damping *= 2;
    return s;
}

double cpu_seconds(const Contender& contender, const scene::Scene& s, double skin,
                   const BenchOptions& options) {
    constexpr double time_limit = 1800;
    const Scratch scratch;
    adapters::RunOptions run{
        .directory = scratch.path(), .time_limit = time_limit, .stop = options.stop};
    if (skin > 0) run.input = with_skin(contender.code->input(s), skin);
    return contender.code->run(s, run, [](const scene::Frame&) {}).cpu_s;
}

struct Turn {
    double start = 0, run = 0;
};

/// A short run and a long one; in its first turn a contender tries all its skins.
void take_turn(Contender& contender, const scene::Scene& s, std::int64_t native_steps,
               const BenchOptions& options) {
    contender.steps = std::max<std::int64_t>(
        std::lround(static_cast<double>(native_steps) * contender.share), 20);
    const std::int64_t few = contender.steps / 10;
    const auto turn_with = [&](double skin) -> Turn {
        if (options.stop.stop_requested()) throw Interrupted();
        return {.start = cpu_seconds(contender, asked_of(contender, s, few), skin, options),
                .run = cpu_seconds(contender, asked_of(contender, s, few + contender.steps), skin,
                                   options)};
    };
    Turn turn = turn_with(contender.skin);
    if (contender.starts.empty()) {
        for (const double skin : contender.skins) {
            const Turn other = turn_with(skin);
            if (other.run - other.start >= turn.run - turn.start) continue;
            turn = other;
            contender.skin = skin;
        }
    }
    contender.starts.push_back(turn.start);
    contender.runs.push_back(turn.run);
}

/// What the steps took, less what goes with them, each the least or the median of all turns. (The
/// least difference would be that of a slow start and a lucky run.)
BenchRow row_of(const Contender& contender, const std::string& scene_name, std::size_t grains) {
    const auto rate = [&](auto choice) {
        const auto chosen = [&](std::vector<double> values) {
            std::sort(values.begin(), values.end());
            return values[choice(values.size())];
        };
        return static_cast<double>(grains) * static_cast<double>(contender.steps) /
               (chosen(contender.runs) - chosen(contender.starts));
    };
    const auto fastest = [](std::size_t) -> std::size_t { return 0; };
    const auto median = [](std::size_t size) { return size / 2; };
    BenchRow row{.name = fmt::format("{}, {}", scene_name, contender.name),
                 .size = static_cast<std::int64_t>(grains),
                 .rate = rate(fastest),
                 .unit = "particle-steps/cpu-s",
                 .details = {{"median rate", fmt::format("{:.3g}", rate(median))},
                             {"turns", fmt::format("{}", contender.runs.size())},
                             {"conventions", contender.conventions}}};
    if (contender.skin > 0) row.details["skin"] = fmt::format("{:g}", contender.skin);
    return row;
}

constexpr const char *native_name = "native", *granular_name = "lammps granular",
                     *hooke_name = "lammps hooke/history";

/// Those that are installed and can express the scene; the others are told in the notes.
std::vector<Contender> contenders_for(const scene::Scene& s, std::vector<Contender> candidates,
                                      BenchReport& report) {
    std::vector<Contender> able;
    for (auto& candidate : candidates) {
        const auto asked = asked_of(candidate, s, 1);
        const auto availability = candidate.code->probe();
        const auto refusal =
            availability.installed ? candidate.code->cannot_express(asked) : availability.reason;
        if (!refusal) {
            able.push_back(std::move(candidate));
        } else {
            report.notes.push_back(fmt::format("{}, {}: {}", s.name, candidate.name, *refusal));
        }
    }
    return able;
}

/// All contenders on one scene; ratios are those of the native engine over the others.
void bench_scene(const std::string& name, const scene::Scene& s, std::int64_t steps,
                 std::vector<Contender> candidates, const BenchOptions& options,
                 BenchReport& report) {
    auto contenders = contenders_for(s, std::move(candidates), report);
    const int turns = options.quick ? 2 : 5;
    for (int turn = 0; turn < turns; ++turn) {
        for (auto& contender : contenders)
            take_turn(contender, s, steps, options);
    }
    const std::size_t first = report.rows.size();
    for (const auto& contender : contenders) {
        report.rows.push_back(row_of(contender, name, mobile_grains(s)));
        if (options.progress) {
            options.progress(fmt::format("{}: {:.1f} million particle-steps/cpu-s",
                                         report.rows.back().name, report.rows.back().rate / 1e6));
        }
    }
    auto& native = report.rows[first];
    for (std::size_t k = 1; k < contenders.size(); ++k) {
        const std::string& other = contenders[k].name;
        const double ratio = native.rate / report.rows[first + k].rate;
        native.ratios[other] = ratio;
        if (other == granular_name || other == hooke_name) {
            report.targets.push_back({.what = fmt::format("native over {}, {}", other, name),
                                      .measured = ratio,
                                      .at_least = 4});
        }
    }
}

}  // namespace

BenchReport bench_dem_friction(const BenchOptions& options) {
    const adapters::NativeDemCode native("bench");
    const adapters::LammpsCode lammps;
    const adapters::LiggghtsCode liggghts;
    const adapters::YadeCode yade;
    // Beside the adapter's own, a quarter of a diameter.
    const std::vector<double> skins{0.15, 0.35, 0.5, 0.7, 1.0};
    const std::vector<Contender> candidates{
        {.name = native_name, .code = &native, .conventions = "liggghts"},
        {.name = granular_name,
         .code = &lammps,
         .conventions = "lammps-granular",
         .share = 0.2,
         .skins = skins},
        {.name = hooke_name,
         .code = &lammps,
         .conventions = "lammps-hooke-history",
         .scale = scene::DampingScale::effective_mass,
         .share = 0.2,
         .skins = skins},
        {.name = "liggghts", .code = &liggghts, .conventions = "liggghts", .share = 0.2},
        {.name = "yade", .code = &yade, .conventions = "yade", .share = 0.1}};
    BenchReport report;
    bench_scene("pipe", pipe(), options.quick ? 40000 : 100000, candidates, options, report);
    const auto filled = hopper(options.quick ? 40 : 100);
    bench_scene("hopper", filled, options.quick ? 4000 : 2500, candidates, options, report);
    return report;
}

}  // namespace crossgrain::app
