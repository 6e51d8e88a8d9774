// crossgrain bench dem: the fluidised bed of the paper (Gamma = 2.19), from the same state at
// t = 40 on, in the native kernels and in the other codes. Before that the crystal moves as a
// column and flatters every neighbour list. What is compared is CPU seconds per particle-step, all
// processes and threads together, so that a busy machine does not decide; contenders take turns,
// and the fastest of several turns counts (the median is told). Of programs the time of a short run
// is taken off that of a long one: what is left is steps.
#include "adapters/lammps/lammps_code.hpp"
#include "adapters/liggghts/liggghts_code.hpp"
#include "adapters/process/find_program.hpp"
#include "adapters/process/process.hpp"
#include "adapters/yade/yade_code.hpp"
#include "app/bench.hpp"
#include "native/base/errors.hpp"
#include "native/base/random.hpp"
#include "native/dem/engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <unistd.h>
#include <utility>

namespace crossgrain::app {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// The bed of the paper: 1024 grains on a period of 128 under a lid of 100.
constexpr double dt = 1e-3, start_time = 40, shaking_period = 6;
constexpr double width_per_grain = 128.0 / 1024, lid_mass_per_grain = 100.0 / 1024;

double process_cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Cycles per second of this thread as it runs: a chain of multiplications (3 cycles) and additions
/// (1 cycle), each waiting for the last, as on all processors of the last ten years.
double clock_frequency() {
    constexpr int links = 2'000'000;
    double fastest = 0;
    for (int attempt = 0; attempt < 10; ++attempt) {
        std::uint64_t x = static_cast<std::uint64_t>(attempt) + 1;
        const double start = process_cpu_seconds();
        for (int i = 0; i < links; ++i)
            x = x * 6364136223846793005U + 1442695040888963407U;
        const double seconds = process_cpu_seconds() - start;
        // Looked at, so that the chain is not left out.
        if (x != 0) fastest = std::max(fastest, 4.0 * links / seconds);
    }
    return fastest;
}

dem::Parameters bed_parameters(std::size_t grains) {
    const auto n = static_cast<double>(grains);
    dem::Parameters p{.diameter = 2,
                      .mass = 1,
                      .stiffness = 495.96987227912376,
                      .damping = 2.2314355131420975,
                      .gravity = 1,
                      .period_x = width_per_grain * n,
                      .plate_stiffness = 495.96987227912376,
                      .lid = dem::InertialLid{.mass = lid_mass_per_grain * n},
                      .dt = dt};
    p.bottom = dem::MovingPlate{.amplitude = 2, .omega = 2 * std::numbers::pi / shaking_period};
    return p;
}

dem::State lattice(std::size_t grains) {
    dem::State s;
    const double width = width_per_grain * static_cast<double>(grains);
    const auto columns = static_cast<std::size_t>(width / 2.03);
    const double spacing = width / static_cast<double>(columns);
    const double row_height = 1.75;
    for (std::uint64_t i = 0; i < grains; ++i) {
        const std::uint64_t row = i / columns;
        const auto v = normal_pair(1, RandomStream::initial_velocity, i);
        s.x.push_back(spacing * (static_cast<double>(i % columns) + (row % 2 ? 0.75 : 0.25)));
        s.y.push_back(2 + row_height * static_cast<double>(row));
        s.vx.push_back(0.1 * v[0]);
        s.vy.push_back(0.1 * v[1]);
    }
    s.lid_height = s.y.back() + 0.5;
    return s;
}

/// The bed at t = 40, by the fastest native kernel.
dem::State fluidised(std::size_t grains) {
    auto p = bed_parameters(grains);
    p.scheme = dem::Scheme::verlet_predicted;
    p.dt = 2 * dt;
    const dem::State start = lattice(grains);
    if (!dem::why_not_simd(p, start)) p.precision = dem::Precision::mixed;
    dem::Engine engine(p, start);
    engine.advance(std::lround(start_time / p.dt));
    dem::State s = engine.state();
    s.step = std::lround(start_time / dt);
    return s;
}

/// Copies side by side, as one bed of the same depth. They part within a few contact times: each
/// grain gets its own kick of 1e-3.
dem::State side_by_side(const dem::State& bed, std::size_t copies) {
    dem::State wide{
        .step = bed.step, .lid_height = bed.lid_height, .lid_velocity = bed.lid_velocity};
    const double width = width_per_grain * static_cast<double>(bed.x.size());
    for (std::size_t copy = 0; copy < copies; ++copy) {
        for (std::size_t i = 0; i < bed.x.size(); ++i) {
            const auto kick = normal_pair(2, RandomStream::initial_velocity, wide.x.size());
            wide.x.push_back(bed.x[i] + width * static_cast<double>(copy));
            wide.y.push_back(bed.y[i]);
            wide.vx.push_back(bed.vx[i] + 1e-3 * kick[0]);
            wide.vy.push_back(bed.vy[i] + 1e-3 * kick[1]);
        }
    }
    return wide;
}

scene::Scene scene_of(const dem::State& s, std::int64_t steps) {
    const std::size_t grains = s.x.size();
    const auto p = bed_parameters(grains);
    scene::Scene scene{.name = fmt::format("bench/bed-{}", grains),
                       .grains = {.diameter = p.diameter, .mass = p.mass},
                       .contact = {.stiffness = p.stiffness, .damping = p.damping},
                       .gravity = p.gravity,
                       .periodic_x = p.period_x,
                       .dt = dt,
                       .steps = steps,
                       .frame_every = steps,
                       .initial = {.x = s.x, .y = s.y, .vx = s.vx, .vy = s.vy}};
    scene.plates = {.stiffness = p.plate_stiffness,
                    .bottom = scene::PrescribedPlate{.amplitude = p.bottom->amplitude,
                                                     .period = shaking_period,
                                                     .phase = start_time / shaking_period},
                    .lid = scene::FreeLid{.mass = lid_mass_per_grain * static_cast<double>(grains),
                                          .height = s.lid_height,
                                          .velocity = s.lid_velocity}};
    return scene;
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

/// What one turn of a contender has given.
struct Turn {
    adapters::RunCost cost;   ///< of `steps` and the start
    adapters::RunCost start;  ///< of the start and what goes with it; nothing for native kernels
    std::int64_t steps = 0;
    std::map<std::string, std::string> details;
};

struct Contender {
    std::string name;
    std::function<Turn(const dem::State&, std::int64_t steps)> run;
    double share = 1;  ///< of the steps of the fastest contender that it is given
    int every = 1;     ///< takes part in every so many turns
    std::vector<Turn> turns = {};
};

Turn run_native(dem::Parameters p, const dem::State& s, std::int64_t steps,
                std::int64_t look_every = 0) {
    dem::Engine engine(p, s);
    engine.advance(steps / 10 + 1);
    const auto before = engine.effort();
    const auto wall = Clock::now();
    const double cpu = process_cpu_seconds();
    for (std::int64_t left = steps; left > 0;) {
        const std::int64_t some = look_every > 0 ? std::min(look_every, left) : left;
        engine.advance(some);
        if (look_every > 0) static_cast<void>(engine.state());
        left -= some;
    }
    Turn turn{.cost = {.cpu_s = process_cpu_seconds() - cpu,
                       .wall_s = std::chrono::duration<double>(Clock::now() - wall).count()},
              .steps = steps};
    const auto after = engine.effort();
    const auto lists = std::max<std::int64_t>(after.neighbour_builds - before.neighbour_builds, 1);
    turn.details = {{"kernel", after.kernel},
                    {"skin", fmt::format("{:.3g}", after.skin)},
                    {"steps per list", fmt::format("{}", steps / lists)}};
    if (after.looked_at > 0) {
        turn.details["neighbours looked at"] = fmt::format("{:.2f}", after.looked_at);
    }
    return turn;
}

Contender native(std::string name, dem::Kernel kernel, dem::Precision precision, int threads = 1,
                 std::int64_t look_every = 0, double share = 1) {
    return {std::move(name),
            [=](const dem::State& s, std::int64_t steps) {
                auto p = bed_parameters(s.x.size());
                p.kernel = kernel;
                p.precision = precision;
                p.threads = threads;
                return run_native(p, s, steps, look_every);
            },
            share};
}

constexpr double time_limit = 1800;

/// A short run and a long one; `cost` runs a scene.
template <class Cost>
Turn short_and_long(const dem::State& s, std::int64_t steps, const Cost& cost) {
    const std::int64_t few = std::max<std::int64_t>(steps / 20, 1);
    return {
        .cost = cost(scene_of(s, few + steps)), .start = cost(scene_of(s, few)), .steps = steps};
}

Contender program(const adapters::GrainCode& code, const BenchOptions& options, double share,
                  int every) {
    return {code.name(),
            [&code, stop = options.stop](const dem::State& s, std::int64_t steps) {
                return short_and_long(s, steps, [&](const scene::Scene& scene) {
                    const Scratch scratch;
                    return code.run(
                        scene,
                        {.directory = scratch.path(), .time_limit = time_limit, .stop = stop},
                        [](const scene::Frame&) {});
                });
            },
            share, every};
}

/// The adapter's own input with another skin, which a later `neighbor` command sets, on so many
/// MPI ranks.
adapters::RunCost run_lammps(const scene::Scene& scene, double skin, int ranks,
                             const std::stop_token& stop) {
    const Scratch scratch;
    std::vector<std::string> argv{"lmp", "-log", "none", "-nocite", "-in"};
    for (auto file : adapters::LammpsCode().input(scene)) {
        if (file.name.starts_with("in.")) {
            const auto run = file.text.rfind("\nrun ");
            file.text.insert(run, fmt::format("\nneighbor {:.3g} bin", skin));
            argv.push_back(file.name);
        }
        std::ofstream(scratch.path() / file.name) << file.text;
    }
    if (ranks > 1) {
        argv.insert(argv.begin(), {"mpirun", "--allow-run-as-root", "--oversubscribe", "-np",
                                   std::to_string(ranks)});
    }
    const auto result = adapters::process::run({.argv = argv,
                                                .directory = scratch.path(),
                                                .extra_environment = {"OMP_NUM_THREADS=1"},
                                                .time_limit = time_limit,
                                                .stop = stop});
    if (result.ending == adapters::process::Ending::stopped) throw Interrupted();
    if (result.ending != adapters::process::Ending::exited || result.status != 0) {
        throw std::runtime_error(
            fmt::format("lmp: {}", adapters::process::describe(result, time_limit)));
    }
    return {.cpu_s = result.cpu_s, .wall_s = result.wall_s};
}

/// Tries all skins in its first turn and keeps to the best.
Contender lammps(const BenchOptions& options, int ranks, double share, int every = 1) {
    return {ranks == 1 ? "lammps" : fmt::format("lammps, {} ranks", ranks),
            [stop = options.stop, ranks, best = std::make_shared<double>(0)](const dem::State& s,
                                                                             std::int64_t steps) {
                const auto with = [&](double skin) {
                    auto turn = short_and_long(s, steps, [&](const scene::Scene& scene) {
                        return run_lammps(scene, skin, ranks, stop);
                    });
                    turn.details = {{"skin", fmt::format("{:.3g}", skin)}};
                    return turn;
                };
                if (*best > 0) return with(*best);
                Turn fastest;
                for (const double skin : {0.3, 0.5, 0.7, 1.0}) {
                    const Turn turn = with(skin);
                    const auto net = [](const Turn& t) { return t.cost.cpu_s - t.start.cpu_s; };
                    if (*best == 0 || net(turn) < net(fastest)) {
                        fastest = turn;
                        *best = skin;
                    }
                }
                return fastest;
            },
            share, every};
}

enum class Choice { fastest, median };

/// Seconds of the steps: what the turns took, less what their starts took, each the least or the
/// median of all turns. (The least difference would be that of a slow start and a lucky run.)
double seconds(const std::vector<Turn>& turns, double adapters::RunCost::*kind, Choice choice) {
    const auto chosen = [&](adapters::RunCost Turn::*part) {
        std::vector<double> values;
        for (const Turn& turn : turns)
            values.push_back(turn.*part.*kind);
        std::sort(values.begin(), values.end());
        return choice == Choice::fastest ? values.front() : values[values.size() / 2];
    };
    return chosen(&Turn::cost) - chosen(&Turn::start);
}

BenchRow row_of(const Contender& contender, std::size_t grains, double frequency) {
    const auto& turns = contender.turns;
    const auto rate = [&](double adapters::RunCost::*kind, Choice choice) {
        return static_cast<double>(turns.front().steps) * static_cast<double>(grains) /
               seconds(turns, kind, choice);
    };
    BenchRow row{.name = contender.name,
                 .size = static_cast<std::int64_t>(grains),
                 .rate = rate(&adapters::RunCost::cpu_s, Choice::fastest),
                 .unit = "particle-steps/cpu-s",
                 .details = turns.back().details};
    row.details["median rate"] =
        fmt::format("{:.3g}", rate(&adapters::RunCost::cpu_s, Choice::median));
    row.details["per wall second"] =
        fmt::format("{:.3g}", rate(&adapters::RunCost::wall_s, Choice::fastest));
    row.details["cycles"] = fmt::format("{:.1f}", frequency / row.rate);
    row.details["turns"] = fmt::format("{}", turns.size());
    return row;
}

/// All contenders take turns on the same state.
class Round {
  public:
    Round(const BenchOptions& options, const dem::State& state, std::int64_t steps, int turns)
        : options_(options), state_(state), steps_(steps), turns_(turns) {}

    void add(Contender contender) { contenders_.push_back(std::move(contender)); }

    void run(double frequency, BenchReport& report) {
        for (int turn = 0; turn < turns_; ++turn) {
            for (auto& contender : contenders_) {
                if (turn % contender.every != 0) continue;
                if (options_.stop.stop_requested()) throw Interrupted();
                const auto steps = std::max<std::int64_t>(
                    std::lround(static_cast<double>(steps_) * contender.share), 10);
                contender.turns.push_back(contender.run(state_, steps));
            }
        }
        for (const auto& contender : contenders_) {
            report.rows.push_back(row_of(contender, state_.x.size(), frequency));
            const auto& row = report.rows.back();
            if (options_.progress) {
                options_.progress(fmt::format("{} grains, {}: {:.1f} million particle-steps/cpu-s",
                                              row.size, row.name, row.rate / 1e6));
            }
        }
    }

  private:
    const BenchOptions& options_;
    const dem::State& state_;
    std::int64_t steps_;
    int turns_;
    std::vector<Contender> contenders_;
};

const BenchRow* find(const BenchReport& report, const std::string& name, std::size_t grains) {
    for (const auto& row : report.rows) {
        if (row.name == name && row.size == static_cast<std::int64_t>(grains)) return &row;
    }
    return nullptr;
}

/// A promise that the ratio of two rows is at least so much; nothing where one is missing.
void promise(BenchReport& report, const std::string& what, const BenchRow* row,
             const BenchRow* other, double at_least, double factor = 1) {
    if (!row || !other) return;
    report.targets.push_back(
        {.what = what, .measured = factor * row->rate / other->rate, .at_least = at_least});
}

constexpr const char* native_double = "native double";
constexpr const char* native_mixed = "native mixed";

void promise_over_lammps(BenchReport& report, std::size_t grains) {
    const auto* lammps_row = find(report, "lammps", grains);
    const auto* mixed = find(report, native_mixed, grains);
    const bool avx512 = mixed && mixed->details.at("kernel").find("AVX3") != std::string::npos;
    promise(report, fmt::format("native double over LAMMPS, N = {}", grains),
            find(report, native_double, grains), lammps_row, avx512 ? 9 : 6);
    promise(report, fmt::format("native mixed over LAMMPS, N = {}", grains), mixed, lammps_row,
            avx512 ? 15 : 9);
}

/// The contenders that are here; of those that are not, why.
void add_programs(Round& round, const BenchOptions& options, BenchReport& report, bool slow_too) {
    static const adapters::LammpsCode lammps_code;
    static const adapters::LiggghtsCode liggghts;
    static const adapters::YadeCode yade;
    const auto present = [&](const adapters::GrainCode& code) {
        const auto availability = code.probe();
        if (!availability.installed) {
            report.notes.push_back(fmt::format("{}: {}", code.name(), availability.reason));
        }
        return availability.installed;
    };
    if (present(lammps_code)) round.add(lammps(options, 1, 1, 2));
    if (!slow_too) return;
    if (present(liggghts)) round.add(program(liggghts, options, 0.5, 2));
    if (present(yade)) round.add(program(yade, options, 0.3, 5));
}

void bench_bed(const BenchOptions& options, const dem::State& state, std::int64_t steps, int turns,
               double frequency, BenchReport& report) {
    using enum dem::Precision;
    Round round(options, state, steps, turns);
    round.add(native(native_double, dem::Kernel::simd, double_precision));
    round.add(native(native_mixed, dem::Kernel::simd, mixed));
    round.add(native("native double, frames", dem::Kernel::simd, double_precision, 1, 100));
    round.add(native("native mixed, frames", dem::Kernel::simd, mixed, 1, 100));
    round.add(native("native scalar", dem::Kernel::scalar, double_precision, 1, 0, 0.3));
    add_programs(round, options, report, true);
    round.run(frequency, report);
    const std::size_t grains = state.x.size();
    promise_over_lammps(report, grains);
    for (const char* name : {native_double, native_mixed}) {
        promise(report, fmt::format("{} with a frame every 100 steps, N = {}", name, grains),
                find(report, fmt::format("{}, frames", name), grains), find(report, name, grains),
                0.9);
    }
}

void bench_wide_bed(const BenchOptions& options, const dem::State& state, std::int64_t steps,
                    double frequency, BenchReport& report) {
    using enum dem::Precision;
    const std::size_t grains = state.x.size();
    Round round(options, state, steps, 5);
    const std::string two = ", 2 threads";
    round.add(native(native_double, dem::Kernel::simd, double_precision));
    round.add(native(native_double + two, dem::Kernel::simd, double_precision, 2));
    round.add(native(native_mixed, dem::Kernel::simd, mixed));
    round.add(native(native_mixed + two, dem::Kernel::simd, mixed, 2));
    if (adapters::LammpsCode().probe().installed && adapters::process::find_program("mpirun") &&
        grains <= 100000) {
        round.add(lammps(options, 2, 0.5, 2));
    }
    round.run(frequency, report);
    for (const char* name : {native_double, native_mixed}) {
        const auto* one_thread = find(report, name, grains);
        const auto* two_threads = find(report, name + two, grains);
        promise(report, fmt::format("{}, N = {} over N = 10000, per core", name, grains),
                one_thread, find(report, name, 10000), 0.6);
        // Twice the ratio per CPU second: what two threads gain when both have a core.
        promise(report, fmt::format("{}, two threads over one, N = {}", name, grains), two_threads,
                one_thread, 1.8, 2);
        promise(report, fmt::format("{}, two threads over LAMMPS on 2 ranks, N = {}", name, grains),
                two_threads, find(report, "lammps, 2 ranks", grains), 8);
    }
}

/// Restitution of two grains, averaged over the moment of contact within a step, against 0.8.
double restitution_error(dem::Scheme scheme, double step) {
    constexpr double exact = 0.8, contact_time = 0.1;
    constexpr int entries = 16, steps = 9;
    double sum = 0;
    for (int n = 0; n < entries * steps; ++n) {
        auto p = bed_parameters(2);
        p = {.diameter = p.diameter,
             .mass = p.mass,
             .stiffness = p.stiffness,
             .damping = p.damping,
             .scheme = scheme,
             .dt = step * (0.96 + 0.01 * (n % steps))};
        const double half = p.diameter / 2 + p.dt / 2 * (n / steps + 0.5) / entries;
        dem::Engine engine(p, {.x = {-half, half}, .y = {0, 0}, .vx = {0.5, -0.5}, .vy = {0, 0}});
        engine.advance(std::lround(2 * contact_time / p.dt) + 4);
        sum += engine.state().vx[1] - engine.state().vx[0];
    }
    return std::abs(sum / (entries * steps) / exact - 1);
}

constexpr double lattice_time = 3;
constexpr std::uint64_t lattice_columns = 64, lattice_rows = 20;

/// Taguchi's section 3: bottom and lid in phase, no gravity. Returns the mean of v_x^2 at t = 3, in
/// the middle of what Fig. 7 shows, and adds to `cpu_s`.
double lattice_shake(dem::Scheme scheme, double step, std::uint64_t seed, double& cpu_s) {
    auto p = bed_parameters(1024);
    p.gravity = 0;
    p.bottom->amplitude = 1;
    const double row_height = std::sqrt(3.0);
    p.lid = dem::MovingPlate{
        .height = row_height * (lattice_rows - 1), .amplitude = 1, .omega = p.bottom->omega};
    p.scheme = scheme;
    const auto steps = std::lround(lattice_time / step);
    p.dt = lattice_time / static_cast<double>(steps);
    dem::State s;
    for (std::uint64_t i = 0; i < lattice_columns * lattice_rows; ++i) {
        const std::uint64_t row = i / lattice_columns;
        const auto v = normal_pair(seed, RandomStream::initial_velocity, i);
        s.x.push_back(p.diameter * static_cast<double>(i % lattice_columns) +
                      (row % 2 ? 1.5 : 0.5));
        s.y.push_back(1 + row_height * static_cast<double>(row));
        s.vx.push_back(0.1 * v[0]);
        s.vy.push_back(0.1 * v[1]);
    }
    const double start = process_cpu_seconds();
    dem::Engine engine(p, s);
    engine.advance(steps);
    cpu_s += process_cpu_seconds() - start;
    double sum = 0;
    for (const double v : engine.state().vx)
        sum += v * v;
    return sum / static_cast<double>(engine.state().vx.size());
}

constexpr std::uint64_t lattice_seeds = 4;

/// Root mean square, over the seeds, of the relative error of that mean, and the CPU seconds of
/// one.
std::pair<double, double> lattice_error(dem::Scheme scheme, double step,
                                        const std::vector<double>& truth) {
    double squares = 0, cpu_s = 0;
    for (std::uint64_t seed = 0; seed < lattice_seeds; ++seed) {
        const double error = lattice_shake(scheme, step, seed, cpu_s) / truth[seed] - 1;
        squares += error * error / lattice_seeds;
    }
    return {std::sqrt(squares), cpu_s / lattice_seeds};
}

/// CPU seconds until e is right within 1 % and the transient of the lattice within 2 %: each scheme
/// at its largest step that is both.
void bench_accuracy(BenchReport& report, const BenchOptions& options) {
    constexpr double contact_time = 0.1;
    std::vector<double> truth;
    double cpu_of_truth = 0;
    for (std::uint64_t seed = 0; seed < lattice_seeds; ++seed) {
        truth.push_back(
            lattice_shake(dem::Scheme::verlet_predicted, contact_time / 2000, seed, cpu_of_truth));
    }
    const std::pair<const char*, dem::Scheme> schemes[] = {
        {"to accuracy: native, Verlet with predicted velocity", dem::Scheme::verlet_predicted},
        {"to accuracy: native, Verlet with half-step velocity", dem::Scheme::verlet_half_step},
        {"to accuracy: native, the paper's Euler", dem::Scheme::taguchi_euler}};
    const double sizes[] = {0.2, 0.1, 0.07, 0.05, 0.03, 0.02, 0.01, 0.005, 0.002, 0.001, 0.0005};
    for (const auto& [name, scheme] : schemes) {
        for (const double size : sizes) {
            if (options.stop.stop_requested()) throw Interrupted();
            const double step = size * contact_time;
            const double e_error = restitution_error(scheme, step);
            if (e_error > 0.01) continue;
            const auto [error, cpu_s] = lattice_error(scheme, step, truth);
            if (error > 0.02) continue;
            report.rows.push_back(
                {.name = name,
                 .size = lattice_columns * lattice_rows,
                 .rate = 1 / cpu_s,
                 .unit = "lattice transients/cpu-s",
                 .details = {{"dt/t_col", fmt::format("{:g}", size)},
                             {"cpu seconds", fmt::format("{:.3g}", cpu_s)},
                             {"error of e", fmt::format("{:.2g} %", 100 * e_error)},
                             {"error of the transient", fmt::format("{:.2g} %", 100 * error)}}});
            if (options.progress) {
                options.progress(
                    fmt::format("{}: dt = {:g} t_col, {:.3g} CPU seconds", name, size, cpu_s));
            }
            break;
        }
    }
    // LAMMPS has the half-step velocity; its steps cost what they cost in the bed.
    const auto* half_step = find(report, schemes[1].first, lattice_columns * lattice_rows);
    const auto* lammps_row = find(report, "lammps", 1024);
    if (!half_step || !lammps_row) return;
    const double size = std::stod(half_step->details.at("dt/t_col"));
    const double steps = lattice_time / (size * contact_time);
    const double cpu_s =
        steps * static_cast<double>(lattice_columns * lattice_rows) / lammps_row->rate;
    report.rows.push_back({.name = "to accuracy: lammps",
                           .size = lattice_columns * lattice_rows,
                           .rate = 1 / cpu_s,
                           .unit = "lattice transients/cpu-s",
                           .details = {{"dt/t_col", fmt::format("{:g}", size)},
                                       {"cpu seconds", fmt::format("{:.3g}", cpu_s)},
                                       {"step", "at its rate in the bed of 1024 grains"}}});
}

void tell_ratios(BenchReport& report) {
    for (auto& row : report.rows) {
        for (const char* other : {"lammps", "lammps, 2 ranks", "liggghts", "yade"}) {
            const auto* reference = find(report, other, static_cast<std::size_t>(row.size));
            if (reference && reference != &row) row.ratios[other] = row.rate / reference->rate;
        }
    }
}

/// The least time that the instructions of one row of the list take: counted in the machine code of
/// the AVX-512 kernels, with one vector of 64 bytes per cycle (two halves side by side on machines
/// of half the width). Every row is loaded and tested, one in two also pushes.
void tell_ceiling(BenchReport& report, double frequency) {
    struct Counted {
        const char* name;
        double test, push, lanes;  // vector instructions per row
    };
    for (const Counted c : {Counted{native_mixed, 28, 16, 16}, Counted{native_double, 20, 20, 8}}) {
        const auto* row = find(report, c.name, 1024);
        if (!row || row->details.at("kernel").find("AVX3") == std::string::npos) {
            continue;
        }
        const double neighbours = std::stod(row->details.at("neighbours looked at"));
        const double cycles = neighbours * (c.test + c.push / 2) / c.lanes;
        report.notes.push_back(fmt::format(
            "{}: ceiling {:.0f} million particle-steps/s: {:.2f} neighbours looked at, {} vector "
            "instructions to load and test a row of {}, {} more where one touches, one per "
            "cycle at {:.2f} GHz; measured {:.0f} % of it",
            c.name, frequency / cycles / 1e6, neighbours, c.test, c.lanes, c.push, frequency / 1e9,
            100 * row->rate * cycles / frequency));
    }
}

}  // namespace

BenchReport bench_dem(const BenchOptions& options) {
    BenchReport report;
    const double frequency = clock_frequency();
    const dem::State small = fluidised(1024);
    bench_bed(options, small, 4000, options.quick ? 4 : 16, frequency, report);
    if (!options.quick) {
        const dem::State medium = fluidised(10000);
        bench_bed(options, medium, 600, 16, frequency, report);
        bench_wide_bed(options, side_by_side(medium, 10), 300, frequency, report);
        bench_wide_bed(options, side_by_side(medium, 100), 60, frequency, report);
        bench_accuracy(report, options);
    }
    tell_ratios(report);
    tell_ceiling(report, frequency);
    return report;
}

}  // namespace crossgrain::app
