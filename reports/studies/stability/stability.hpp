// Where methods stop working, found by running them: `crossgrain stability`.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <complex>
#include <functional>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace crossgrain::studies {

/// What the matrices of the tried packing itself say of a threshold.
struct PackingTheory {
    double limit = 0;                 ///< largest stable dt
    std::complex<double> eigenvalue;  ///< of the one-step map at the limit
    double residual = 0;              ///< of that eigenpair, |M s - z s|/(|z| |s|)
};

/// Largest parameter at which a method still works, found by bisection.
struct StabilityThreshold {
    std::string code;                      ///< e.g. "native-dem"
    std::string method;                    ///< e.g. "verlet-predicted, e = 0.8"
    std::string parameter;                 ///< e.g. "dt"
    double works = 0;                      ///< largest value that worked
    double fails = 0;                      ///< smallest value that failed
    std::optional<PackingTheory> packing;  ///< of closed contacts
    std::optional<double> theory;          ///< what is compared
    std::string theory_source;             ///< e.g. "analytic:packing_time_step_limit"
    double tolerance = 0;                  ///< relative, of the comparison with theory
    [[nodiscard]] double measured() const noexcept { return (works + fails) / 2; }
};

/// One point of a map.
struct StabilityPoint {
    std::string code;
    std::map<std::string, double> at;       ///< axis -> value
    std::map<std::string, std::string> in;  ///< what is named instead, e.g. {"reading", "P"}
    std::string state;   ///< e.g. "ok", "inaccurate", "blow-up", "saturated", "absorbing"
    std::string detail;  ///< e.g. "energy residual -12 %"
};

/// Where theory draws the line across a map: the largest value of `parameter` that is stable, for
/// the points that are `at` and `in` the same (of those keys that are given).
struct TheoryLine {
    std::map<std::string, double> at;
    std::map<std::string, std::string> in;
    std::string parameter;  ///< e.g. "dt"
    double limit = 0;
    std::string source;  ///< e.g. "analytic:lattice_time_step_limit"
};

struct StabilityReport {
    std::string case_name;
    std::vector<StabilityThreshold> thresholds;
    std::vector<TheoryLine> theory;
    std::vector<StabilityPoint> points;
};

/// Whether the measured threshold is within its tolerance of theory; true without a theory.
[[nodiscard]] bool holds_theory(const StabilityThreshold& threshold);

/// {case, thresholds, theory, points}, and tables of the same.
[[nodiscard]] nlohmann::json stability_json(const StabilityReport& report);
[[nodiscard]] std::string stability_text(const StabilityReport& report);

}  // namespace crossgrain::studies
