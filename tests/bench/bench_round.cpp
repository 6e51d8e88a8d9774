#include "tests/bench/bench_round.hpp"

#include "native/base/cpu_time.hpp"
#include "native/base/errors.hpp"
#include "native/numerics/median.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace crossgrain::bench {
namespace {

enum class Choice { fastest, median };

/// Seconds of the steps: what the turns took, less what their starts took, each the least or the
/// median of all turns. (The least difference would be that of a slow start and a lucky run.)
double seconds(const std::vector<Turn>& turns, double adapters::RunCost::*kind, Choice choice) {
    const auto chosen = [&](adapters::RunCost Turn::*part) {
        std::vector<double> values;
        for (const Turn& turn : turns)
            values.push_back(turn.*part.*kind);
        return choice == Choice::fastest ? std::ranges::min(values) : numerics::median(values);
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

}  // namespace

void Round::run(double frequency, BenchReport& report) {
    for (int turn = 0; turn < turns_; ++turn) {
        for (auto& contender : contenders_) {
            if (turn % contender.every != 0) continue;
            if (options_.stop.stop_requested()) throw Interrupted();
            const auto steps = std::max<std::int64_t>(
                std::lround(static_cast<double>(steps_) * contender.share), 10);
            contender.turns.push_back(contender.run(steps));
        }
    }
    for (const auto& contender : contenders_) {
        report.rows.push_back(row_of(contender, grains_, frequency));
        const auto& row = report.rows.back();
        if (options_.progress) {
            options_.progress(fmt::format("{} grains, {}: {:.1f} million particle-steps/cpu-s",
                                          row.size, row.name, row.rate / 1e6));
        }
    }
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

const BenchRow* find(const BenchReport& report, const std::string& name, std::size_t grains) {
    for (const auto& row : report.rows) {
        if (row.name == name && row.size == static_cast<std::int64_t>(grains)) return &row;
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
            const auto* reference = find(report, other, static_cast<std::size_t>(row.size));
            if (reference && reference != &row) row.ratios[other] = row.rate / reference->rate;
        }
    }
}

}  // namespace crossgrain::bench
