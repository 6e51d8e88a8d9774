#include "adapters/run/store/results_json.hpp"

#include "adapters/run/store/packed_bytes.hpp"

#include <nlohmann/json.hpp>

#include <stdexcept>

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
    json pictures = json::array();
    for (const auto& picture : results.pictures)
        pictures.push_back(picture_to_json(picture));
    json findings = json::array();
    for (const auto& f : results.findings)
        findings.push_back({{"name", f.name}, {"label", f.label}, {"detail", f.detail}});
    return {{"measurements", std::move(measurements)},
            {"series", std::move(series)},
            {"snapshots", std::move(snapshots)},
            {"pictures", std::move(pictures)},
            {"findings", std::move(findings)}};
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
    for (const auto& picture : document.value("pictures", json::array()))
        results.pictures.push_back(picture_from_json(picture));
    for (const auto& f : document.value("findings", json::array())) {
        results.findings.push_back(
            {.name = f.at("name"), .label = f.at("label"), .detail = f.at("detail")});
    }
    return results;
}

json picture_to_json(const measure::Picture& picture) {
    return {{"name", picture.name},       {"title", picture.title},
            {"width", picture.width},     {"height", picture.height},
            {"palette", picture.palette}, {"pixels", pack(picture.pixels)}};
}

measure::Picture picture_from_json(const json& document) {
    measure::Picture picture{.name = document.at("name"),
                             .title = document.at("title"),
                             .width = document.at("width"),
                             .height = document.at("height"),
                             .pixels = {},
                             .palette = document.at("palette")};
    constexpr std::size_t most = std::size_t{1} << 15;  // of either side
    if (picture.width > most || picture.height > most)
        throw std::invalid_argument("a picture is larger than 32768 pixels");
    picture.pixels =
        unpack(document.at("pixels").get_ref<const std::string&>(), picture.width * picture.height);
    return picture;
}

}  // namespace crossgrain::store
