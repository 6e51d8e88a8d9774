#include "reports/store/results_json.hpp"

#include <nlohmann/json.hpp>

namespace crossgrain::store {

using nlohmann::json;

json to_json(const measure::Results& results) {
    json measurements = json::array();
    for (const auto& m : results.measurements) {
        measurements.push_back({{"observable", m.observable},
                                {"value", m.value},
                                {"stderr", m.standard_error},
                                {"systematic", m.systematic},
                                {"n", m.n},
                                {"unit", m.unit},
                                {"settings", m.settings}});
    }
    json series = json::array();
    for (const auto& s : results.series) {
        series.push_back(
            {{"name", s.name}, {"columns", s.columns}, {"values", s.values}, {"units", s.units}});
    }
    json snapshots = json::array();
    for (const auto& s : results.snapshots) {
        snapshots.push_back({{"time", s.time}, {"x", s.x}, {"y", s.y}});
    }
    return {{"measurements", std::move(measurements)},
            {"series", std::move(series)},
            {"snapshots", std::move(snapshots)}};
}

measure::Results results_from_json(const json& document) {
    measure::Results results;
    for (const auto& m : document.at("measurements")) {
        results.measurements.push_back({.observable = m.at("observable"),
                                        .value = m.at("value"),
                                        .standard_error = m.at("stderr"),
                                        .systematic = m.at("systematic"),
                                        .n = m.at("n"),
                                        .unit = m.at("unit"),
                                        .settings = m.at("settings")});
    }
    for (const auto& s : document.at("series")) {
        results.series.push_back({.name = s.at("name"),
                                  .columns = s.at("columns"),
                                  .values = s.at("values"),
                                  .units = s.at("units")});
    }
    for (const auto& s : document.at("snapshots")) {
        results.snapshots.push_back({.time = s.at("time"), .x = s.at("x"), .y = s.at("y")});
    }
    return results;
}

}  // namespace crossgrain::store
