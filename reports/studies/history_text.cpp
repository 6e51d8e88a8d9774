#include "reports/documents/text_table.hpp"
#include "reports/studies/history.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace crossgrain::studies {

using nlohmann::json;

json history_document(const std::vector<HistorySeries>& history) {
    json all = json::array();
    for (const auto& series : history) {
        json points = json::array();
        for (const auto& point : series.points) {
            points.push_back({{"entry", point.run_id},
                              {"created", point.created},
                              {"value", point.value},
                              {"stderr", point.standard_error},
                              {"version", point.version}});
        }
        json band = series.drift == Drift::too_few ? json() : json{series.low, series.high};
        all.push_back({{"case", series.case_name},
                       {"variant", series.variant},
                       {"code", series.code},
                       {"observable", series.observable},
                       {"unit", series.unit},
                       {"seed", series.seed},
                       {"settings", json::parse(series.settings_json, nullptr, false)},
                       {"points", std::move(points)},
                       {"band", std::move(band)},
                       {"allowance", series.allowance},
                       {"status", to_string(series.drift)}});
    }
    return {{"series", std::move(all)}};
}

std::string history_table(const std::vector<HistorySeries>& history) {
    reports::TextTable table(
        {"case", "variant", "code", "observable", "values", "newest", "earlier band", "status"});
    for (const auto& series : history) {
        const auto& newest = series.points.back();
        table.add({series.case_name, series.variant.empty() ? "-" : series.variant, series.code,
                   series.observable, std::to_string(series.points.size()),
                   newest.standard_error > 0
                       ? fmt::format("{:.6g} +- {:.2g}", newest.value, newest.standard_error)
                       : fmt::format("{:.6g}", newest.value),
                   series.drift == Drift::too_few
                       ? "-"
                       : fmt::format("{:.6g} ... {:.6g}", series.low, series.high),
                   to_string(series.drift)});
    }
    return table.empty() ? "the store holds no runs yet\n" : table.text(0);
}

}  // namespace crossgrain::studies
