#include "cases/measure/waves/wave_profile.hpp"

#include "cases/measure/waves/over_samples.hpp"
#include "native/numerics/mean_with_error.hpp"

#include <algorithm>
#include <cmath>

namespace crossgrain::measure {
namespace {

// Distance from the peak, in bins, at which the profile first falls to `level` in a direction.
std::optional<double> distance_to(const std::vector<double>& profile, std::size_t peak,
                                  double level, bool forward) {
    const std::size_t bins = profile.size();
    double before = profile[peak];
    for (std::size_t d = 1; d < bins; ++d) {
        const double here = profile[(forward ? peak + d : peak + bins - d) % bins];
        if (here <= level) return static_cast<double>(d - 1) + (before - level) / (before - here);
        before = here;
    }
    return std::nullopt;
}

}  // namespace

std::optional<WaveShape> wave_shape(const std::vector<double>& profile) {
    const auto peak = static_cast<std::size_t>(std::ranges::max_element(profile) - profile.begin());
    const double height = profile[peak];
    if (!(height > 0)) return std::nullopt;
    const auto level = [&](double share, bool forward) {
        return distance_to(profile, peak, share * height, forward);
    };
    const auto front_half = level(0.5, true), back_half = level(0.5, false);
    const auto front_foot = level(0.25, true), back_foot = level(0.25, false);
    if (!front_half || !back_half || !front_foot || !back_foot) return std::nullopt;
    const double front = *front_foot - *level(0.75, true);
    const double back = *back_foot - *level(0.75, false);
    return WaveShape{height, *front_half + *back_half, back / front};
}

Series profile_series(const AlignedProfiles& profiles, const ProfileScale& scale) {
    Series series{
        .name = "profile",
        .columns = {"X", "density", "err", "null"},
        .values = std::vector<std::vector<double>>(4),
        .units = {scale.length_unit, scale.density_unit, scale.density_unit, scale.density_unit}};
    const std::size_t bins = profiles.waves.front().size();
    const std::size_t crest = bins / 2;
    for (std::size_t x = 0; x < bins; ++x) {
        std::vector<double> here, null;
        for (std::size_t p = 0; p < profiles.waves.size(); ++p) {
            here.push_back(1 + profiles.waves[p][x]);
            null.push_back(1 + profiles.nulls[p][x]);
        }
        const numerics::MeanWithError density = numerics::mean_with_error(here);
        const double position = static_cast<double>(x) - static_cast<double>(crest);
        series.values[0].push_back(position * scale.bin);
        series.values[1].push_back(density.value * scale.density);
        series.values[2].push_back(density.standard_error * scale.density);
        series.values[3].push_back(numerics::mean_with_error(null).value * scale.density);
    }
    return series;
}

std::vector<WaveShape> append_profile(const AlignedProfiles& profiles, Results& results) {
    std::vector<double> amplitudes, null_amplitudes, excess, steepness;
    std::vector<WaveShape> shapes;
    std::size_t sharper = 0;
    for (std::size_t p = 0; p < profiles.waves.size(); ++p) {
        amplitudes.push_back(std::ranges::max(profiles.waves[p]));
        null_amplitudes.push_back(std::ranges::max(profiles.nulls[p]));
        excess.push_back(amplitudes.back() - null_amplitudes.back());
        const auto shape = wave_shape(profiles.waves[p]);
        if (!shape) continue;
        shapes.push_back(*shape);
        steepness.push_back(std::log(shape->steepness));
        if (shape->steepness > 1) ++sharper;
    }
    auto& out = results.measurements;
    out.push_back(over_samples("profile_amplitude", amplitudes, "1"));
    out.push_back(over_samples("profile_null_amplitude", null_amplitudes, "1"));
    out.push_back(over_samples("profile_excess", excess, "1"));
    if (shapes.size() < profiles.waves.size()) return shapes;
    out.push_back(over_samples("profile_asymmetry", steepness, "1"));
    out.push_back(fraction("profile_front_sharper", sharper, profiles.waves.size()));
    return shapes;
}

}  // namespace crossgrain::measure
