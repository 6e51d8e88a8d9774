// crossgrain bench hopper: grain moves per CPU second of the automaton's engines (L = 800, N = 20),
// the cost of a move against L and N, the sweep of the paper's Fig. 7 over its 801 angles, and what
// two threads at once give. What is timed is the CPU time of the thread at work, so that a busy
// machine does not decide; contenders take turns, and the fastest iteration counts (the median is
// told).
#include "native/base/cpu_time.hpp"
#include "native/base/errors.hpp"
#include "native/hopper/fast_engine.hpp"
#include "native/hopper/plain_engine.hpp"
#include "native/numerics/median.hpp"
#include "tests/bench/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace crossgrain::bench {
namespace {

using Clock = std::chrono::steady_clock;
using Table = std::shared_ptr<const hopper::CandidateTable>;

constexpr int paper_levels = 800, paper_outlet = 20, paper_iterations = 100, paper_angles = 801;

/// The hopper of Fig. 7 with walls of slope 3.
hopper::Parameters paper_hopper() {
    return {.outlet = paper_outlet,
            .levels = paper_levels,
            .angle = 2 * std::atan(1.0 / 3) * 180 / std::numbers::pi,
            .rules = {.c_d = 0.01, .c_o = 0, .c_i = 0.1, .c_w = 0.1},
            .seed = 1};
}

/// What has been done, and what it took.
struct Turn {
    double cpu_s = 0;
    double moves = 0;
    [[nodiscard]] double rate() const { return moves / cpu_s; }
};

/// Each iteration by itself; `moves` counts those done so far.
std::vector<Turn> time_each(std::int64_t iterations, const std::function<std::int64_t()>& moves,
                            const std::function<void()>& iterate) {
    std::vector<Turn> turns;
    for (std::int64_t i = 0; i < iterations; ++i) {
        const std::int64_t before = moves();
        const double start = thread_cpu_seconds();
        iterate();
        const double cpu_s = thread_cpu_seconds() - start;
        turns.push_back({.cpu_s = cpu_s, .moves = static_cast<double>(moves() - before)});
    }
    return turns;
}

/// Independent runs on one thread; several take turns at every level, to hide each other's latency.
std::vector<Turn> time_fast(const hopper::Parameters& p, const Table& table, std::uint32_t runs,
                            std::int64_t iterations) {
    std::vector<std::unique_ptr<hopper::FastEngine>> engines;
    for (std::uint32_t run = 0; run < runs; ++run) {
        auto own = p;
        own.run = run;
        engines.push_back(std::make_unique<hopper::FastEngine>(own, table));
    }
    const auto moves = [&] {
        std::int64_t sum = 0;
        for (const auto& engine : engines)
            sum += engine->record().moves;
        return sum;
    };
    return time_each(iterations, moves, [&] {
        for (auto& engine : engines)
            engine->begin_iteration();
        for (int n = 0; n < p.levels; ++n) {
            for (auto& engine : engines)
                engine->visit_level(static_cast<std::size_t>(n));
        }
        for (auto& engine : engines)
            engine->end_iteration();
    });
}

std::vector<Turn> time_plain(const hopper::Parameters& p, std::int64_t iterations) {
    hopper::PlainEngine engine(p);
    return time_each(
        iterations, [&] { return engine.record().moves; }, [&] { engine.advance(1); });
}

/// A share of the 801 angles 10, 10.1, ..., 90 degrees, hoppers built and all.
Turn sweep(int first, int step, const std::stop_token& stop) {
    Turn turn;
    const double start = thread_cpu_seconds();
    auto p = paper_hopper();
    const auto table = std::make_shared<hopper::CandidateTable>(hopper::integer_energies(p.rules));
    for (int i = first; i < paper_angles; i += step) {
        if (stop.stop_requested()) throw Interrupted();
        p.angle = 10 + i / 10.0;
        p.run = static_cast<std::uint32_t>(i);
        hopper::FastEngine engine(p, table);
        engine.advance(paper_iterations);
        turn.moves += static_cast<double>(engine.record().moves);
    }
    turn.cpu_s = thread_cpu_seconds() - start;
    return turn;
}

/// A contender, and its iterations so far.
struct Contender {
    BenchRow row;
    std::function<std::vector<Turn>()> take_turn;
    std::vector<double> rates;  ///< of single iterations
};

void take_turns(std::vector<Contender>& contenders, int turns, const BenchOptions& options) {
    for (int turn = 0; turn < turns; ++turn) {
        for (auto& contender : contenders) {
            if (options.stop.stop_requested()) throw Interrupted();
            for (const Turn& iteration : contender.take_turn()) {
                contender.rates.push_back(iteration.rate());
            }
        }
    }
    for (auto& contender : contenders) {
        auto& row = contender.row;
        row.rate = std::ranges::max(contender.rates);
        row.unit = "moves/cpu-s";
        row.details["ns per move"] = fmt::format("{:.2f}", 1e9 / row.rate);
        row.details["median"] = fmt::format("{:.3g}", numerics::median(contender.rates));
        if (options.progress) {
            options.progress(fmt::format("{}: {:.1f} M moves/cpu-s", row.name, row.rate / 1e6));
        }
    }
}

std::int64_t sites(const hopper::Parameters& p) {
    return static_cast<std::int64_t>(hopper::Geometry(p.outlet, p.levels, p.angle).sites());
}

Table table_of(const hopper::Parameters& p) {
    return std::make_shared<hopper::CandidateTable>(hopper::integer_energies(p.rules));
}

/// Plain, fast, and fast runs that take turns, in one room.
std::vector<BenchRow> engines(const BenchOptions& options) {
    const auto p = paper_hopper();
    const auto table = table_of(p);
    const std::int64_t iterations = options.quick ? 10 : 40;
    std::vector<Contender> contenders;
    contenders.push_back({.row = {.name = "fast", .size = sites(p)},
                          .take_turn = [=] { return time_fast(p, table, 1, iterations); }});
    contenders.push_back({.row = {.name = "plain", .size = sites(p)},
                          .take_turn = [=] { return time_plain(p, iterations / 5); }});
    for (const std::uint32_t runs : {2U, 4U}) {
        contenders.push_back(
            {.row = {.name = fmt::format("fast, {} runs interleaved", runs), .size = sites(p)},
             .take_turn = [=] { return time_fast(p, table, runs, iterations / runs); }});
    }
    take_turns(contenders, options.quick ? 3 : 20, options);
    std::vector<BenchRow> rows;
    for (auto& contender : contenders)
        rows.push_back(std::move(contender.row));
    rows[0].ratios["plain"] = rows[0].rate / rows[1].rate;
    for (std::size_t i = 2; i < rows.size(); ++i) {
        rows[i].ratios["fast"] = rows[i].rate / rows[0].rate;
    }
    return rows;
}

/// The cost of a move in hoppers of other sizes, the first fifth of the filling of each.
std::vector<BenchRow> sizes(const BenchOptions& options) {
    const auto table = table_of(paper_hopper());
    std::vector<Contender> contenders;
    const auto add = [&](int outlet, int levels) {
        auto p = paper_hopper();
        p.outlet = outlet;
        p.levels = levels;
        const auto iterations = std::min<std::int64_t>(options.quick ? 5 : 20,
                                                       sites(p) / (std::int64_t{5} * outlet) + 1);
        contenders.push_back(
            {.row = {.name = fmt::format("fast, L = {}, N = {}", levels, outlet),
                     .size = sites(p),
                     .details = {{"L", fmt::format("{}", levels)},
                                 {"N", fmt::format("{}", outlet)}}},
             .take_turn = [p, table, iterations] { return time_fast(p, table, 1, iterations); }});
    };
    for (const int levels : {100, 200, 400, 800, 1600, 3200})
        add(paper_outlet, levels);
    for (const int outlet : {2, 5, 10, 40, 80, 160})
        add(outlet, paper_levels);
    take_turns(contenders, options.quick ? 2 : 20, options);
    const double reference = contenders[3].row.rate;
    std::vector<BenchRow> rows;
    for (auto& contender : contenders) {
        contender.row.ratios["L = 800, N = 20"] = contender.row.rate / reference;
        rows.push_back(std::move(contender.row));
    }
    return rows;
}

/// CPU seconds of the sweep; the quick bench takes every 40th angle and scales up.
BenchRow whole_sweep(const BenchOptions& options, double& cpu_s) {
    const int step = options.quick ? 40 : 1;
    const Turn turn = sweep(0, step, options.stop);
    cpu_s = turn.cpu_s * (options.quick ? paper_angles / ((paper_angles + step - 1.0) / step) : 1);
    BenchRow row{.name = "fast, sweep over 801 angles",
                 .size = paper_angles,
                 .rate = turn.rate(),
                 .unit = "moves/cpu-s",
                 .details = {{"cpu-s", fmt::format("{:.1f}", cpu_s)},
                             {"moves", fmt::format("{:.4g}", turn.moves)}}};
    if (options.quick) row.details["angles"] = "every 40th, scaled up";
    if (options.progress) options.progress(fmt::format("{}: {:.1f} cpu-s", row.name, cpu_s));
    return row;
}

/// Twice the CPU time of a share of the angles alone over that of two shares at once, each on
/// its own thread: what they take from each other.
BenchRow two_threads(const BenchOptions& options) {
    constexpr int share = 80;  // every 80th angle
    const auto infinity = std::numeric_limits<double>::infinity();
    double alone = infinity, together = infinity, alone_wall = infinity, together_wall = infinity;
    double moves = 0;
    for (int turn = 0; turn < (options.quick ? 2 : 8); ++turn) {
        const auto start = Clock::now();
        const Turn first = sweep(0, share, options.stop);
        const Turn second = sweep(40, share, options.stop);
        const auto middle = Clock::now();
        Turn a, b;
        {
            const std::jthread other([&] { b = sweep(40, share, {}); });
            a = sweep(0, share, {});
        }
        moves = a.moves + b.moves;
        alone = std::min(alone, first.cpu_s + second.cpu_s);
        together = std::min(together, a.cpu_s + b.cpu_s);
        alone_wall = std::min(alone_wall, std::chrono::duration<double>(middle - start).count());
        together_wall =
            std::min(together_wall, std::chrono::duration<double>(Clock::now() - middle).count());
    }
    BenchRow row{.name = "fast, two threads",
                 .size = 2,
                 .rate = moves / (together / 2),
                 .unit = "moves/s of two free cores"};
    row.ratios["one thread"] = 2 * alone / together;
    row.details["scaling of wall time, as the machine was"] =
        fmt::format("{:.2f}", alone_wall / together_wall);
    if (options.progress) {
        options.progress(fmt::format("{}: {:.2f} times one", row.name, 2 * alone / together));
    }
    return row;
}

}  // namespace

BenchReport bench_hopper(const BenchOptions& options) {
    BenchReport report;
    report.rows = engines(options);
    const double fast = report.rows[0].rate, ratio = report.rows[0].ratios.at("plain");
    auto by_size = sizes(options);
    const double largest = by_size[3].rate / by_size[5].rate;
    double sweep_cpu_s = 0;
    auto whole = whole_sweep(options, sweep_cpu_s);
    auto threads = two_threads(options);
    const double scaling = threads.ratios.at("one thread");

    for (auto& row : by_size)
        report.rows.push_back(std::move(row));
    report.rows.push_back(std::move(whole));
    report.rows.push_back(std::move(threads));
    report.targets = {
        {.what = "grain moves per CPU second, L = 800, N = 20", .measured = fast, .at_least = 5e7},
        {.what = "fast over plain, L = 800, N = 20", .measured = ratio, .at_least = 4},
        {.what = "CPU seconds of the sweep over 801 angles",
         .measured = sweep_cpu_s,
         .at_most = 30},
        {.what = "two threads over one", .measured = scaling, .at_least = 1.8},
        {.what = "cost of a move, L = 3200 over L = 800", .measured = largest, .at_most = 1.25}};
    report.notes = {
        "plain visits every site of a level in a random order, as the rules say, so its "
        "cost grows with the sites and not only with the moves"};
    return report;
}

}  // namespace crossgrain::bench
