// crossgrain bench lga: site updates (site x step x replica) per CPU second of the lattice gas by
// width of words, against the table engine in the same run; the dense case; the cost of measuring;
// what two blocks of words on two threads give; where the time of a step goes; and how exactly a
// probability is honoured. What is timed is the CPU time of the thread at work, so that a busy
// machine does not decide; contenders take turns, and the fastest stretch counts.
#include "native/base/cpu_time.hpp"
#include "native/base/errors.hpp"
#include "native/lga/ensemble.hpp"
#include "native/lga/profile.hpp"
#include "tests/bench/bench.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <barrier>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <thread>
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

/// An ensemble that is timed in stretches.
struct Contender {
    std::string name;
    std::unique_ptr<lga::Ensemble> gas;
    int replicas = 0;
    std::int64_t stretch = 0;  ///< steps
    bool measures = false;
    double best_s = std::numeric_limits<double>::infinity();  ///< per step

    void take_turn() {
        lga::BinValues values;
        const double start = thread_cpu_seconds();
        for (std::int64_t done = 0; done < stretch; done += every) {
            gas->advance(every);
            if (measures) gas->measure(bin, {}, values);
        }
        best_s = std::min(best_s, (thread_cpu_seconds() - start) / static_cast<double>(stretch));
    }
    [[nodiscard]] double rate() const { return 220.0 * 11.0 * replicas / best_s; }
};

Contender sliced(const std::string& name, lga::Model model, int bits, bool quick) {
    model.replicas = bits;
    Contender c{.name = name,
                .gas = lga::make_sliced_ensemble(model, bits),
                .replicas = bits,
                .stretch = quick ? 50 : 200};
    c.gas->advance(quick ? 500 : 3000);  // into the steady state
    return c;
}

Contender table(const std::string& name, lga::Model model, bool quick) {
    model.replicas = 4;
    Contender c{.name = name,
                .gas = lga::make_table_ensemble(model),
                .replicas = 4,
                .stretch = quick ? 50 : 100};
    c.gas->advance(quick ? 500 : 3000);
    return c;
}

void take_turns(std::vector<Contender>& contenders, const BenchOptions& options) {
    const int turns = options.quick ? 5 : 25;
    for (int turn = 0; turn < turns; ++turn) {
        for (auto& contender : contenders) {
            if (options.stop.stop_requested()) throw Interrupted();
            contender.take_turn();
        }
    }
    if (!options.progress) return;
    for (const auto& c : contenders) {
        options.progress(fmt::format("{}: {:.3g} site updates per CPU second", c.name, c.rate()));
    }
}

const Contender& named(const std::vector<Contender>& contenders, const std::string& name) {
    return *std::ranges::find(contenders, name, &Contender::name);
}

std::string words_of(int bits) {
    return fmt::format("{}-bit words", bits);
}

/// The usual case in every width, measured, dense, and by table.
std::vector<Contender> contenders(bool quick) {
    const auto usual = reading_p(0.8, 1.0), dense = reading_p(0.5, 1.8);
    const int widest = lga::word_widths().back();
    std::vector<Contender> all;
    for (const int bits : lga::word_widths()) {
        all.push_back(sliced(words_of(bits), usual, bits, quick));
    }
    all.push_back(sliced("measured", usual, widest, quick));
    all.back().measures = true;
    all.push_back(sliced("dense", dense, widest, quick));
    all.push_back(table("table", usual, quick));
    all.push_back(table("table, dense", dense, quick));
    return all;
}

/// Work of two blocks at once on two threads over that of one alone, in the same CPU time of a
/// thread: what the cores share (memory, clock rate) shows, other programs do not.
double two_thread_scaling(const BenchOptions& options) {
    const int widest = lga::word_widths().back();
    const auto model = reading_p(0.8, 1.0);
    const std::int64_t steps = options.quick ? 100 : 400;
    std::vector<Contender> blocks;
    for (int i = 0; i < 2; ++i)
        blocks.push_back(sliced("block", model, widest, options.quick));
    double one = std::numeric_limits<double>::infinity(), two = one;
    for (int turn = 0; turn < (options.quick ? 2 : 6); ++turn) {
        if (options.stop.stop_requested()) throw Interrupted();
        const double start = thread_cpu_seconds();
        blocks[0].gas->advance(steps);
        one = std::min(one, thread_cpu_seconds() - start);
        std::barrier together(2);
        double spent[2] = {};
        const auto work = [&](std::size_t i) {
            together.arrive_and_wait();
            const double begin = thread_cpu_seconds();
            blocks[i].gas->advance(steps);
            spent[i] = thread_cpu_seconds() - begin;
        };
        { const std::jthread first(work, 0), second(work, 1); }
        two = std::min(two, std::max(spent[0], spent[1]));
    }
    return 2 * one / two;
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

void add_targets(BenchReport& report, const std::vector<Contender>& all, double scaling,
                 double bias) {
    const int widest = lga::word_widths().back();
    const auto rate = [&](const std::string& name) { return named(all, name).rate(); };
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
    auto all = contenders(options.quick);
    take_turns(all, options);
    BenchReport report;
    for (const auto& c : all) {
        const double against =
            named(all, c.name.find("dense") == std::string::npos ? "table" : "table, dense").rate();
        report.rows.push_back({.name = c.name,
                               .size = c.replicas,
                               .rate = c.rate(),
                               .unit = "site updates/cpu-s",
                               .ratios = {{"table engine", c.rate() / against}},
                               .details = {{"replicas", std::to_string(c.replicas)}}});
    }
    const int widest = lga::word_widths().back();
    report.rows.push_back(profile_row("profile", reading_p(0.8, 1.0), widest, options.quick));
    report.rows.push_back(
        profile_row("profile, dense", reading_p(0.5, 1.8), widest, options.quick));
    add_targets(report, all, two_thread_scaling(options), largest_bias(options));
    report.notes.push_back("reading P, L = 220, W = 11, rho = 1, p = .8, g = b = .5; dense: rho = "
                           "1.8, p = .5; counted "
                           "are the L x W sites, the two wall columns beside them are not");
    report.notes.push_back(
        "random bits: words per site as counted, times the time of one in a loop of its own; what "
        "is left of their phases are collisions and gravity");
    return report;
}

}  // namespace crossgrain::bench
