// Every observable and every cost over the entries of the store, and whether the newest value has
// left the band of the earlier ones.
#pragma once

#include "adapters/run/store/store.hpp"
#include "native/base/enum_words.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace crossgrain::studies {

enum class Drift {
    in_band,
    left_band,  ///< outside [lowest, highest] of the earlier values by more than its error allows
    too_few     ///< fewer than two earlier values
};
constexpr auto words(Drift /*of*/) {
    return std::array{"in_band", "left_band", "too_few"};
}

struct HistorySeries {
    std::string case_name, variant, code, observable, unit, settings_json;
    std::uint64_t seed = 0;
    std::vector<store::HistoryPoint> points;  ///< oldest first
    double low = 0, high = 0;                 ///< of the earlier values
    double allowance = 0;                     ///< what the newest value may leave the band by
    Drift drift = Drift::too_few;
};

/// Groups the points by case, variant, settings, seed, code and observable, and judges each series.
///
/// Allowance: 1.96 standard errors of the newest value, at least 1e-9 max(1, |value|) (round-off
/// grown over a run); for costs, which state no error, 30 % and at least 0.2 s (how far repeated
/// runs on a shared machine scatter).
[[nodiscard]] std::vector<HistorySeries> history_of(std::vector<store::HistoryPoint> points);

/// {"series": [...]}, the answer of `crossgrain history`.
[[nodiscard]] nlohmann::json history_document(const std::vector<HistorySeries>& history);
[[nodiscard]] std::string history_table(const std::vector<HistorySeries>& history);

}  // namespace crossgrain::studies
