#include "reports/studies/history.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace crossgrain::studies {
namespace {

double allowance(const store::HistoryPoint& newest) {
    if (newest.observable == "cpu_s") return std::max(0.2, 0.3 * newest.value);
    return std::max(1.96 * newest.standard_error, 1e-9 * std::max(1.0, std::abs(newest.value)));
}

void judge(HistorySeries& series) {
    const auto& newest = series.points.back();
    const auto earlier = static_cast<std::ptrdiff_t>(series.points.size()) - 1;
    if (earlier < 2) return;
    const auto [low, high] =
        std::minmax_element(series.points.begin(), series.points.begin() + earlier,
                            [](const auto& a, const auto& b) { return a.value < b.value; });
    series.low = low->value;
    series.high = high->value;
    series.allowance = allowance(newest);
    const bool inside = newest.value >= series.low - series.allowance &&
                        newest.value <= series.high + series.allowance;
    series.drift = inside ? Drift::in_band : Drift::left_band;
}

}  // namespace

std::vector<HistorySeries> history_of(std::vector<store::HistoryPoint> points) {
    std::map<
        std::tuple<std::string, std::string, std::string, std::uint64_t, std::string, std::string>,
        std::vector<store::HistoryPoint>>
        groups;
    for (auto& point : points) {
        groups[{point.case_name, point.variant, point.settings_json, point.seed, point.code,
                point.observable}]
            .push_back(std::move(point));
    }
    std::vector<HistorySeries> result;
    for (auto& [key, group] : groups) {
        HistorySeries series{.case_name = group.front().case_name,
                             .variant = group.front().variant,
                             .code = group.front().code,
                             .observable = group.front().observable,
                             .unit = group.front().unit,
                             .settings_json = group.front().settings_json,
                             .seed = group.front().seed};
        series.points = std::move(group);
        judge(series);
        result.push_back(std::move(series));
    }
    return result;
}

}  // namespace crossgrain::studies
