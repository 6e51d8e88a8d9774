// Enough and no more: the cheapest way to an observable within a tolerance, from a chart.
#pragma once

#include "reports/studies/chart/chart.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace crossgrain::studies {

/// One point of a chart and how many runs of it are enough.
struct Choice {
    ChartPoint point;
    std::int64_t runs = 0;  ///< so many, averaged, are within the tolerance with 95 % confidence
    double cpu_s = 0;       ///< of all of them, starts included
};

/// A way that is cheaper, and why it is not enough.
struct Rejected {
    ChartPoint point;
    double cpu_s = 0;    ///< of one run
    bool wrong = false;  ///< shown to be off by more than the tolerance; else too uncertain to say
};

/// Physics that a variant leaves out, and whether the observable notices.
struct DroppedPhysics {
    std::string drops, variant;
    double difference = 0, half_width = 0;  ///< from the full variant, 95 %
    std::string verdict;                    ///< "agree", "disagree", "undecided"
    double cost_ratio = 1;                  ///< CPU seconds per run over those of the full variant
};

struct Advice {
    std::string observable;
    double tolerance = 0;
    std::optional<Choice> cheapest;
    std::optional<Rejected> next_cheaper;
    std::vector<DroppedPhysics> dropped;
    std::string reason;  ///< why there is no cheapest; usually empty
};

/// Runs needed so that |bias| + 1.96 sqrt(bias_stderr^2 + scatter^2/runs) <= tolerance, with
/// bias_stderr that of the chart; nothing if no number of runs is enough.
[[nodiscard]] std::optional<std::int64_t> runs_needed(const ChartPoint& point, double tolerance);

/// The chart's own margins play no part.
[[nodiscard]] Advice advise(const ChartedObservable& charted, double tolerance);

/// Lines for people, and {observable, tolerance, enough, not_enough, dropped, reason}.
[[nodiscard]] std::string advice_text(const Advice& advice);
[[nodiscard]] nlohmann::json advice_json(const Advice& advice);

}  // namespace crossgrain::studies
