#include "adapters/run/store/results_json.hpp"

#include "adapters/run/store/packed_bytes.hpp"

#include <nlohmann/json.hpp>

#include <stdexcept>

namespace crossgrain::measure {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Series, name, columns, values, units)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Snapshot, time, x, y)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Finding, name, label, detail)

}  // namespace crossgrain::measure

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
    json pictures = json::array();
    for (const auto& picture : results.pictures)
        pictures.push_back(picture_to_json(picture));
    return {{"measurements", std::move(measurements)},
            {"series", results.series},
            {"snapshots", results.snapshots},
            {"pictures", std::move(pictures)},
            {"findings", results.findings}};
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
    document.at("series").get_to(results.series);
    document.at("snapshots").get_to(results.snapshots);
    for (const auto& picture : document.value("pictures", json::array()))
        results.pictures.push_back(picture_from_json(picture));
    document.value("findings", json::array()).get_to(results.findings);
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
