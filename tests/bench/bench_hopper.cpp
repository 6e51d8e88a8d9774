// crossgrain bench hopper: grain moves per CPU second of the automaton's engines (L = 800, N = 20),
// the cost of a move against L and N, the sweep of the paper's Fig. 7 over its 801 angles, and what
// two threads at once give. Each iteration is timed by itself, and the fastest counts.
#include "native/base/errors.hpp"
#include "native/hopper/fast_engine.hpp"
#include "native/hopper/plain_engine.hpp"
#include "tests/bench/bench_round.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace crossgrain::bench {
namespace {

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

/// Each iteration by itself; `moves` counts those done so far.
std::vector<Turn> time_each(std::int64_t iterations, const std::function<std::int64_t()>& moves,
                            const std::function<void()>& iterate) {
    std::vector<Turn> turns;
    for (std::int64_t i = 0; i < iterations; ++i) {
        const std::int64_t before = moves();
        const auto cost = timed(iterate);
        turns.push_back({.cost = cost, .steps = static_cast<double>(moves() - before)});
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

Table table_of(const hopper::Parameters& p) {
    return std::make_shared<hopper::CandidateTable>(hopper::integer_energies(p.rules));
}

/// A share of the 801 angles 10, 10.1, ..., 90 degrees, hoppers built and all; returns the moves.
double sweep(int first, int step, const std::stop_token& stop) {
    double moves = 0;
    auto p = paper_hopper();
    const auto table = table_of(p);
    for (int i = first; i < paper_angles; i += step) {
        if (stop.stop_requested()) throw Interrupted();
        p.angle = 10 + i / 10.0;
        p.run = static_cast<std::uint32_t>(i);
        hopper::FastEngine engine(p, table);
        engine.advance(paper_iterations);
        moves += static_cast<double>(engine.record().moves);
    }
    return moves;
}

/// Moves in a hopper, by its sites.
Work moves_in(const hopper::Parameters& p) {
    const auto sites = hopper::Geometry(p.outlet, p.levels, p.angle).sites();
    return {"moves", static_cast<std::int64_t>(sites)};
}

/// Plain, fast, and fast runs that take turns, in one room.
void engines(const BenchOptions& options, BenchReport& report) {
    const auto p = paper_hopper();
    const auto table = table_of(p);
    Round round(options, options.quick ? 10 : 40, options.quick ? 3 : 20);
    const auto fast = [=](std::uint32_t runs) {
        return [=](std::int64_t iterations) { return time_fast(p, table, runs, iterations); };
    };
    round.add({"fast", moves_in(p), fast(1)});
    round.add({"plain", moves_in(p), [=](std::int64_t n) { return time_plain(p, n); }, 0.2});
    for (const std::uint32_t runs : {2U, 4U})
        round.add(
            {fmt::format("fast, {} runs interleaved", runs), moves_in(p), fast(runs), 1.0 / runs});
    round.run(report);
    tell_ratios(report, {"fast", "plain"});
}

std::string room_name(int outlet, int levels) {
    return fmt::format("fast, L = {}, N = {}", levels, outlet);
}

/// The cost of a move in hoppers of other sizes, the first fifth of the filling of each.
void sizes(const BenchOptions& options, BenchReport& report) {
    const auto table = table_of(paper_hopper());
    Round round(options, options.quick ? 5 : 20, options.quick ? 2 : 20);
    const auto add = [&](int outlet, int levels) {
        auto p = paper_hopper();
        p.outlet = outlet;
        p.levels = levels;
        const Work work = moves_in(p);
        const std::int64_t most = work.size / (std::int64_t{5} * outlet) + 1;
        const auto turn = [=](std::int64_t iterations) {
            return time_fast(p, table, 1, std::min(iterations, most));
        };
        round.add(
            {.name = room_name(outlet, levels),
             .work = work,
             .run = turn,
             .details = {{"L", fmt::format("{}", levels)}, {"N", fmt::format("{}", outlet)}}});
    };
    for (const int levels : {100, 200, 400, 800, 1600, 3200})
        add(paper_outlet, levels);
    for (const int outlet : {2, 5, 10, 40, 80, 160})
        add(outlet, paper_levels);
    const std::size_t first = report.rows.size();
    round.run(report);
    const double reference = row_named(report, room_name(paper_outlet, paper_levels)).rate;
    for (std::size_t i = first; i < report.rows.size(); ++i)
        report.rows[i].ratios["L = 800, N = 20"] = report.rows[i].rate / reference;
}

/// CPU seconds of the sweep; the quick bench takes every 40th angle and scales up.
double whole_sweep(const BenchOptions& options, BenchReport& report) {
    const int step = options.quick ? 40 : 1;
    double moves = 0;
    const auto cost = timed([&] { moves = sweep(0, step, options.stop); });
    const double scale = paper_angles / ((paper_angles + step - 1) / step * 1.0);
    const double cpu_s = cost.cpu_s * scale;
    BenchRow row{.name = "fast, sweep over 801 angles",
                 .size = paper_angles,
                 .rate = moves / cost.cpu_s,
                 .unit = "moves/cpu-s",
                 .details = {{"cpu-s", fmt::format("{:.1f}", cpu_s)},
                             {"moves", fmt::format("{:.4g}", moves)}}};
    if (options.quick) row.details["angles"] = "every 40th, scaled up";
    if (options.progress) options.progress(fmt::format("{}: {:.1f} cpu-s", row.name, cpu_s));
    report.rows.push_back(std::move(row));
    return cpu_s;
}

}  // namespace

BenchReport bench_hopper(const BenchOptions& options) {
    BenchReport report;
    engines(options, report);
    sizes(options, report);
    const double sweep_cpu_s = whole_sweep(options, report);
    // Two shares of the sweep, of every 80th angle.
    const ThreadScaling threads = two_threads(options, options.quick ? 2 : 8,
                                              [](int share) { return sweep(40 * share, 80, {}); });
    report.rows.push_back(row_of_threads("fast, two threads", "moves", threads));

    const auto& fast = row_named(report, "fast");
    const auto rate_of = [&](int levels) {
        return row_named(report, room_name(paper_outlet, levels)).rate;
    };
    report.targets = {{.what = "grain moves per CPU second, L = 800, N = 20",
                       .measured = fast.rate,
                       .at_least = 5e7},
                      {.what = "fast over plain, L = 800, N = 20",
                       .measured = fast.ratios.at("plain"),
                       .at_least = 4},
                      {.what = "CPU seconds of the sweep over 801 angles",
                       .measured = sweep_cpu_s,
                       .at_most = 30},
                      {.what = "two threads over one", .measured = threads.cpu, .at_least = 1.8},
                      {.what = "cost of a move, L = 3200 over L = 800",
                       .measured = rate_of(800) / rate_of(3200),
                       .at_most = 1.25}};
    report.notes = {
        "plain visits every site of a level in a random order, as the rules say, so its "
        "cost grows with the sites and not only with the moves"};
    return report;
}

}  // namespace crossgrain::bench
