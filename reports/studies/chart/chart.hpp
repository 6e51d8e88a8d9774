// Speed against accuracy: what the runs of a ladder cost and how far they are off.
#pragma once

#include "reports/session/session.hpp"

#include <string>
#include <utility>
#include <vector>

namespace crossgrain::studies {

/// One code at one rung of the ladder, for one observable. Errors are absolute, in its unit.
struct ChartPoint {
    std::string code, variant;
    std::string drops;  ///< physics the variant leaves out; usually empty
    std::vector<std::pair<std::string, std::string>> parameters;
    std::size_t runs = 0;    ///< replicas behind the numbers
    double cpu_s = 0;        ///< of stepping in one run, the least of all replicas
    double start_s = 0;      ///< of starting the code, likewise
    double value = 0;        ///< mean over the replicas
    double bias = 0;         ///< value - reference
    double bias_stderr = 0;  ///< standard error of the bias, that of the reference included
    double scatter = 0;      ///< standard deviation of one run
    double error = 0;        ///< root mean square error of one run: bias and scatter
    bool accurate = false;   ///< error within the margin
    bool on_front = false;   ///< nothing cheaper has a smaller error
};

struct ChartedObservable {
    std::string observable, against, reason, unit;
    double margin = 0;
    double reference = 0, reference_stderr = 0;
    std::vector<ChartPoint> points;  ///< cheapest first
    std::string problem;             ///< why there are none; usually empty
};

/// What has no place in a chart.
struct ChartFailure {
    std::string code, variant;
    std::string status;  ///< of its runs: "run_failed", "not_expressible", ... or "not_measured"
    std::string reason;
};

struct Chart {
    std::string case_name, title;
    std::vector<ChartedObservable> observables;
    std::vector<ChartFailure> failures;
};

/// From the runs of a case's chart suite.
[[nodiscard]] Chart chart_of(const judge::CaseReport& item);

/// CPU seconds that a code takes to start: where the straight line through (work, seconds) of runs
/// of different length meets zero work, with equal relative errors; 0 if it falls below, or if all
/// runs are equally long.
[[nodiscard]] double start_up(const std::vector<std::pair<double, double>>& work_and_seconds);

/// Marks the points that no cheaper one beats. Sorts by cost.
void mark_front(std::vector<ChartPoint>& points);

}  // namespace crossgrain::studies
