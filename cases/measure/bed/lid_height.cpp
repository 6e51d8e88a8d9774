#include "cases/measure/bed/lid_height.hpp"

#include "cases/measure/bed/plate_motion.hpp"
#include "cases/measure/statistics/time_mean.hpp"

#include <algorithm>
#include <functional>

namespace crossgrain::measure {

LidHeight::LidHeight(const scene::Scene& scene, LidHeightOptions options)
    : options_(options), plates_(scene.plates) {}

void LidHeight::add(const scene::Frame& frame) {
    const auto lid = lid_state(plates_, frame);
    if (!lid) return;
    time_.push_back(frame.time);
    height_.push_back(lid->height);
    if (const auto bottom = bottom_state(plates_, frame.time)) bottom_.push_back(bottom->height);
}

void LidHeight::finish(Results& results) {
    if (time_.empty()) return;
    if (const auto mean = time_mean(time_, height_, options_.skip, driving_period(plates_))) {
        results.measurements.push_back({.observable = "mean_lid_height",
                                        .value = mean->value,
                                        .standard_error = mean->standard_error,
                                        .n = mean->blocks,
                                        .unit = "l",
                                        .settings = {{"skip", options_.skip}}});
    }
    Series series{.name = "lid-height", .columns = {"t", "h"}, .values = {time_, height_}};
    if (!bottom_.empty()) {
        std::vector<double> spacing(height_.size());
        std::ranges::transform(height_, bottom_, spacing.begin(), std::minus{});
        series.columns.insert(series.columns.end(), {"bottom", "spacing"});
        series.values.push_back(bottom_);
        series.values.push_back(std::move(spacing));
    }
    results.series.push_back(std::move(series));
}

}  // namespace crossgrain::measure
