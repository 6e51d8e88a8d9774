// Speed, measured side by side in one run: `crossgrain bench`.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace crossgrain::bench {

/// One contender at one size.
struct BenchRow {
    std::string name;                            ///< e.g. "native double"
    std::int64_t size = 0;                       ///< e.g. number of grains, sites
    double rate = 0;                             ///< work per CPU second
    std::string unit;                            ///< e.g. "particle-steps/cpu-s"
    std::map<std::string, double> ratios;        ///< this rate over another contender's, same run
    std::map<std::string, std::string> details;  ///< e.g. {"skin", "0.9"}, {"cycles", "12.1"}
};

/// A required figure, as measured on this machine.
struct BenchTarget {
    std::string what;  ///< e.g. "native double over LAMMPS, N = 1024"
    double measured = 0;
    double at_least = 0;  ///< 0 when there is no lower bound
    double at_most = 0;   ///< 0 when there is no upper bound
    [[nodiscard]] bool met() const noexcept {
        return (at_least == 0 || measured >= at_least) && (at_most == 0 || measured <= at_most);
    }
};

struct BenchReport {
    std::vector<BenchRow> rows;
    std::vector<BenchTarget> targets;
    std::vector<std::string> notes;  ///< e.g. a contender that is not installed, and why
};

struct BenchOptions {
    bool quick = false;  ///< shorter runs, for a look and for tests; figures are less certain
    std::stop_token stop;
    std::function<void(const std::string&)> progress;  ///< one line per finished contender
};

/// One named bench. To add one, add a line to benches.cpp.
struct Bench {
    std::string name;  ///< e.g. "lga"
    std::string title;
    std::function<BenchReport(const BenchOptions&)> run;
};

[[nodiscard]] const std::vector<Bench>& benches();
/// Throws CaseError with the nearest name.
[[nodiscard]] const Bench& bench_named(const std::string& name);

/// {bench, machine, rows, targets, notes}, and tables of the same.
[[nodiscard]] nlohmann::json bench_json(const Bench& bench, const BenchReport& report);
[[nodiscard]] std::string bench_text(const Bench& bench, const BenchReport& report);

[[nodiscard]] BenchReport bench_dem(const BenchOptions& options);
[[nodiscard]] BenchReport bench_dem_friction(const BenchOptions& options);
[[nodiscard]] BenchReport bench_lga(const BenchOptions& options);
[[nodiscard]] BenchReport bench_hopper(const BenchOptions& options);

}  // namespace crossgrain::bench
