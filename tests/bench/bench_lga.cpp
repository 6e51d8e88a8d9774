// crossgrain bench lga: site updates (site x step x replica) per CPU second of the lattice gas by
// width of words, against the table engine in the same run; the dense case; the cost of measuring;
// what two blocks of words on two threads give; where the time of a step goes; and how exactly a
// probability is honoured.
#include "native/base/errors.hpp"
#include "native/lga/ensemble.hpp"
#include "native/lga/profile.hpp"
#include "tests/bench/bench_round.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace crossgrain::bench {
namespace {

constexpr int bin = 10;    // sites per bin of the measured runs
constexpr int every = 10;  // steps between two measurements

/// A site with movers along these directions.
lga::SiteState site(std::initializer_list<int> movers, int rests = 0) {
    unsigned bits = 0;
    for (const int i : movers)
        bits |= 1U << (i % lga::directions);
    return {.movers = static_cast<std::uint8_t>(bits), .rests = static_cast<std::uint8_t>(rests)};
}

/// Reading P, L = 220, W = 11, g = b = 1/2.
lga::Model reading_p(double dissipation, double density) {
    lga::Model model{.length = 220,
                     .width = 11,
                     .density = density,
                     .gravity = 0.5,
                     .roughness = 0.5,
                     .seed = 1};
    model.gravity_rule.up_to_rest = true;
    const double p = dissipation;
    const auto add = [&](const lga::SiteState& before, const lga::SiteState& after,
                         double probability) {
        model.rules.push_back({.before = before, .after = after, .probability = probability});
    };
    for (int i = 0; i < 3; ++i) {
        add(site({i, i + 3}), site({i + 1, i + 4}), (1 - p) / 2);
        add(site({i, i + 3}), site({i + 2, i + 5}), (1 - p) / 2);
        add(site({i, i + 3}), site({}, 2), p);
        add(site({i, i + 3}, 1), site({}, 3), 1);
    }
    for (int i = 0; i < lga::directions; ++i)
        add(site({i, i + 2}), site({i + 1}, 1), p);
    for (int i = 0; i < 2; ++i) {
        add(site({i, i + 2, i + 4}), site({i + 1, i + 3, i + 5}), 1 - p);
        add(site({i, i + 2, i + 4}), site({}, 3), p);
        add(site({i, i + 2, i + 4}, 1), site({}, 4), 1);
    }
    return model;
}

using Gas = std::shared_ptr<lga::Ensemble>;

/// In the steady state.
Gas steady(Gas gas, bool quick) {
    gas->advance(quick ? 500 : 3000);
    return gas;
}

Gas sliced(lga::Model model, int bits, bool quick) {
    model.replicas = bits;
    return steady(lga::make_sliced_ensemble(model, bits), quick);
}

Gas by_table(lga::Model model, int replicas, bool quick) {
    model.replicas = replicas;
    return steady(lga::make_table_ensemble(model), quick);
}

enum class Measured { no, yes };

/// Steps of so many replicas, measured every so often or not.
Contender contender(std::string name, const Gas& gas, int replicas, double share = 1,
                    Measured measured = Measured::no) {
    const auto turn = [=](std::int64_t steps) {
        lga::BinValues values;
        const auto cost = timed([&] {
            for (std::int64_t done = 0; done < steps; done += every) {
                gas->advance(every);
                if (measured == Measured::yes) gas->measure(bin, {}, values);
            }
        });
        return std::vector{Turn{.cost = cost, .steps = static_cast<double>(steps)}};
    };
    return {.name = std::move(name),
            .work = {"site updates", replicas, 220.0 * 11.0 * replicas},
            .run = turn,
            .share = share,
            .details = {{"replicas", std::to_string(replicas)}}};
}

std::string words_of(int bits) {
    return fmt::format("{}-bit words", bits);
}

constexpr int table_replicas = 4;

/// The usual case in every width, measured, dense, and by table.
void all_engines(const BenchOptions& options, BenchReport& report) {
    const bool quick = options.quick;
    const auto usual = reading_p(0.8, 1.0), dense = reading_p(0.5, 1.8);
    const int widest = lga::word_widths().back();
    Round round(options, quick ? 50 : 200, quick ? 5 : 25);
    for (const int bits : lga::word_widths())
        round.add(contender(words_of(bits), sliced(usual, bits, quick), bits));
    round.add(contender("measured", sliced(usual, widest, quick), widest, 1, Measured::yes));
    round.add(contender("dense", sliced(dense, widest, quick), widest));
    for (const auto& [name, model] : {std::pair{"table", &usual}, {"table, dense", &dense}})
        round.add(contender(name, by_table(*model, table_replicas, quick), table_replicas, 0.5));
    round.run(report);
    for (auto& row : report.rows) {
        const bool is_dense = row.name.find("dense") != std::string::npos;
        row.ratios["table engine"] =
            row.rate / row_named(report, is_dense ? "table, dense" : "table").rate;
    }
}

/// Two blocks of words at once on two threads: what the cores share (memory, clock rate) shows,
/// other programs do not.
ThreadScaling two_blocks(const BenchOptions& options) {
    const int widest = lga::word_widths().back();
    const std::int64_t steps = options.quick ? 100 : 400;
    const auto model = reading_p(0.8, 1.0);
    const Gas blocks[2] = {sliced(model, widest, options.quick),
                           sliced(model, widest, options.quick)};
    return two_threads(options, options.quick ? 2 : 6, [&](int i) {
        blocks[i]->advance(steps);
        return 220.0 * 11.0 * widest * static_cast<double>(steps);
    });
}

/// Largest difference between some probabilities that are no short binary fractions and how often
/// decisions say yes; of 10^10 decisions or so, which resolves 5e-6.
double largest_bias(const BenchOptions& options) {
    const int widest = lga::word_widths().back();
    const std::int64_t words = 10'000'000'000 / widest;
    double bias = 0;
    for (const double p : {0.1, 0.8, 1.0 / 3}) {
        if (options.stop.stop_requested()) throw Interrupted();
        bias = std::max(bias, std::abs(lga::frequency(p, widest, words) - p));
    }
    return bias;
}

std::string percent(double part, double whole) {
    return fmt::format("{:.0f} %", 100 * part / whole);
}

/// Shares of a step, by width of words.
BenchRow profile_row(const std::string& name, const lga::Model& model, int bits, bool quick) {
    const auto p =
        lga::profile(model, bits, quick ? 500 : 3000, quick ? 20 : 100, quick ? 3 : 10, bin);
    const double step = p.step_ns();
    const double random = p.words_per_site * p.random_word_ns;
    const auto phase = [&](lga::Phase which) {
        return p.phase_ns[static_cast<std::size_t>(which)];
    };
    const double sites = 1e9 * bits;
    const double collision =
        phase(lga::Phase::collision) + phase(lga::Phase::vertical_gravity) - random;
    return {.name = name,
            .size = bits,
            .rate = sites / step,
            .unit = "site updates/cpu-s",
            .ratios = {{"random bits alone", random / step}},
            .details = {{"ns per word", fmt::format("{:.1f}", step)},
                        {"random words per site", fmt::format("{:.1f}", p.words_per_site)},
                        {"ns per random word", fmt::format("{:.2f}", p.random_word_ns)},
                        {"random bits", percent(random, step)},
                        {"collisions and gravity", percent(collision, step)},
                        {"walls", percent(phase(lga::Phase::reflection), step)},
                        {"relocation", percent(phase(lga::Phase::relocation), step)},
                        {"propagation", percent(phase(lga::Phase::propagation), step)},
                        {"measurement (every 10 steps)", percent(p.measurement_ns / every, step)}}};
}

void add_targets(BenchReport& report, double scaling, double bias) {
    const int widest = lga::word_widths().back();
    const auto rate = [&](const std::string& name) { return row_named(report, name).rate; };
    const auto widths = lga::word_widths();
    const auto has = [&](int bits) { return std::ranges::find(widths, bits) != widths.end(); };
    if (has(512)) {
        report.targets.push_back(
            {.what = "512-bit words, p = .8", .measured = rate(words_of(512)), .at_least = 4e9});
        report.targets.push_back(
            {.what = "512-bit words, dense", .measured = rate("dense"), .at_least = 2e9});
    } else {
        report.notes.push_back("this processor has no words of 512 bits");
    }
    if (has(256)) {
        report.targets.push_back(
            {.what = "256-bit words, p = .8", .measured = rate(words_of(256)), .at_least = 2e9});
    } else {
        report.notes.push_back("this processor has no words of 256 bits");
    }
    report.targets.push_back({.what = fmt::format("{} over the table engine", words_of(widest)),
                              .measured = rate(words_of(widest)) / rate("table"),
                              .at_least = 25});
    report.targets.push_back({.what = "measuring, share of the run",
                              .measured = 1 - rate("measured") / rate(words_of(widest)),
                              .at_most = 0.15});
    report.targets.push_back(
        {.what = "two threads over one", .measured = scaling, .at_least = 1.8});
    report.targets.push_back(
        {.what = "largest bias of a probability", .measured = bias, .at_most = 0x1p-16});
}

}  // namespace

BenchReport bench_lga(const BenchOptions& options) {
    BenchReport report;
    all_engines(options, report);
    const int widest = lga::word_widths().back();
    report.rows.push_back(profile_row("profile", reading_p(0.8, 1.0), widest, options.quick));
    report.rows.push_back(
        profile_row("profile, dense", reading_p(0.5, 1.8), widest, options.quick));
    const ThreadScaling threads = two_blocks(options);
    report.rows.push_back(row_of_threads("two blocks, two threads", "site updates", threads));
    add_targets(report, threads.cpu, largest_bias(options));
    report.notes.push_back("reading P, L = 220, W = 11, rho = 1, p = .8, g = b = .5; dense: rho = "
                           "1.8, p = .5; counted "
                           "are the L x W sites, the two wall columns beside them are not");
    report.notes.push_back(
        "random bits: words per site as counted, times the time of one in a loop of its own; what "
        "is left of their phases are collisions and gravity");
    return report;
}

}  // namespace crossgrain::bench
