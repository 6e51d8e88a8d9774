#include "tests/bench/bench_round.hpp"

#include "native/base/cpu_time.hpp"
#include "native/base/errors.hpp"
#include "native/numerics/median.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <barrier>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

namespace crossgrain::bench {
namespace {

using Clock = std::chrono::steady_clock;

enum class Choice { fastest, median };

/// Seconds per step: what the turns took, less what their starts took, each the least or the median
/// of all turns. (The least difference would be that of a slow start and a lucky run.)
double seconds_per_step(const std::vector<Turn>& turns, double adapters::RunCost::*kind,
                        Choice choice) {
    const auto chosen = [&](adapters::RunCost Turn::*part) {
        std::vector<double> values;
        for (const Turn& turn : turns)
            values.push_back(turn.*part.*kind / turn.steps);
        return choice == Choice::fastest ? std::ranges::min(values) : numerics::median(values);
    };
    return chosen(&Turn::cost) - chosen(&Turn::start);
}

BenchRow row_of(const Contender& contender, double frequency) {
    const auto& [unit, size, per_step] = contender.work;
    const auto rate = [&](double adapters::RunCost::*kind, Choice choice) {
        return per_step / seconds_per_step(contender.turns, kind, choice);
    };
    BenchRow row{.name = contender.name,
                 .size = size,
                 .rate = rate(&adapters::RunCost::cpu_s, Choice::fastest),
                 .unit = unit + "/cpu-s",
                 .details = contender.details};
    const auto& last = contender.turns.back().details;
    row.details.insert(last.begin(), last.end());
    row.details["median rate"] =
        fmt::format("{:.3g}", rate(&adapters::RunCost::cpu_s, Choice::median));
    row.details["per wall second"] =
        fmt::format("{:.3g}", rate(&adapters::RunCost::wall_s, Choice::fastest));
    row.details["cycles"] = fmt::format("{:.3g}", frequency / row.rate);
    row.details["turns"] = fmt::format("{}", contender.turns.size());
    return row;
}

}  // namespace

adapters::RunCost timed(const std::function<void()>& work) {
    const auto wall = Clock::now();
    const double cpu = process_cpu_seconds();
    work();
    return {.cpu_s = process_cpu_seconds() - cpu,
            .wall_s = std::chrono::duration<double>(Clock::now() - wall).count()};
}

void Round::run(BenchReport& report) {
    for (int turn = 0; turn < turns_; ++turn) {
        for (auto& contender : contenders_) {
            if (turn % contender.every != 0) continue;
            if (options_.stop.stop_requested()) throw Interrupted();
            const auto steps =
                std::max<std::int64_t>(std::lround(double(steps_) * contender.share), 1);
            for (Turn& stretch : contender.run(steps))
                contender.turns.push_back(std::move(stretch));
        }
    }
    const double frequency = clock_frequency();
    for (const auto& contender : contenders_) {
        report.rows.push_back(row_of(contender, frequency));
        const auto& row = report.rows.back();
        if (options_.progress) {
            options_.progress(fmt::format("{}, size {}: {:.1f} million {}", row.name, row.size,
                                          row.rate / 1e6, row.unit));
        }
    }
}

ThreadScaling two_threads(const BenchOptions& options, int turns,
                          const std::function<double(int)>& work) {
    struct Least {
        double value = std::numeric_limits<double>::infinity();
        void take(double other) { value = std::min(value, other); }
    };
    Least alone[2], together[2], alone_wall, together_wall;
    double done[2] = {};
    for (int turn = 0; turn < turns; ++turn) {
        if (options.stop.stop_requested()) throw Interrupted();
        std::barrier start(2);
        const auto one = [&](int i, Least& least, bool waits) {
            if (waits) start.arrive_and_wait();
            const double begin = thread_cpu_seconds();
            done[i] = work(i);
            least.take(thread_cpu_seconds() - begin);
        };
        alone_wall.take(timed([&] {
                            one(0, alone[0], false);
                            one(1, alone[1], false);
                        }).wall_s);
        together_wall.take(timed([&] {
                               const std::jthread first([&] { one(0, together[0], true); });
                               one(1, together[1], true);
                           }).wall_s);
    }
    const double busy = together[0].value + together[1].value;
    return {.cpu = 2 * (alone[0].value + alone[1].value) / busy,
            .wall = alone_wall.value / together_wall.value,
            .rate = 2 * (done[0] + done[1]) / busy};
}

BenchRow row_of_threads(const std::string& name, const std::string& unit,
                        const ThreadScaling& threads) {
    return {.name = name,
            .size = 2,
            .rate = threads.rate,
            .unit = unit + "/s of two free cores",
            .ratios = {{"one thread", threads.cpu}},
            .details = {
                {"scaling of wall time, as the machine was", fmt::format("{:.2f}", threads.wall)}}};
}

const BenchRow& row_named(const BenchReport& report, const std::string& name) {
    return *std::ranges::find(report.rows, name, &BenchRow::name);
}

// A chain of multiplications (3 cycles) and additions (1 cycle), each waiting for the last, as on
// all processors of the last ten years.
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

const BenchRow* find(const BenchReport& report, const std::string& name, std::int64_t size) {
    for (const auto& row : report.rows) {
        if (row.name == name && row.size == size) return &row;
    }
    return nullptr;
}

void add_target(BenchReport& report, const std::string& what, const BenchRow* row,
                const BenchRow* other, double at_least, double factor) {
    if (!row || !other) return;
    report.targets.push_back(
        {.what = what, .measured = factor * row->rate / other->rate, .at_least = at_least});
}

void tell_ratios(BenchReport& report, const std::vector<std::string>& others) {
    for (auto& row : report.rows) {
        for (const auto& other : others) {
            const auto* reference = find(report, other, row.size);
            if (reference && reference != &row) row.ratios[other] = row.rate / reference->rate;
        }
    }
}

}  // namespace crossgrain::bench
