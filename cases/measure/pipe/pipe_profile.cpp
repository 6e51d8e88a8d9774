#include "cases/measure/pipe/pipe_profile.hpp"

#include "cases/measure/gas/gas_profile.hpp"
#include "cases/measure/gas/gas_window.hpp"
#include "cases/measure/pipe/pipe_modes.hpp"
#include "cases/measure/statistics/mean_with_error.hpp"
#include "native/base/random.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

namespace crossgrain::measure {
namespace {

constexpr std::uint64_t shuffle_seed = 1995;

/// Fisher & Yates, anew for each frame.
std::vector<std::uint16_t> shuffled_bins(std::span<const std::uint16_t> counts, std::size_t frame) {
    std::vector<std::uint16_t> shuffled(counts.begin(), counts.end());
    for (std::size_t i = counts.size() - 1; i > 0; --i) {
        const double u = uniform(shuffle_seed, RandomStream::jitter, frame * counts.size() + i);
        std::swap(shuffled[i], shuffled[static_cast<std::size_t>(u * static_cast<double>(i + 1))]);
    }
    return shuffled;
}

/// The k of the strongest wave, k = 1 to 7.
std::size_t strongest_wave(const PipeRecord& record) {
    std::size_t strongest = 1;
    double most = 0;
    for (std::size_t k = 1; k <= 7; ++k) {
        double power = 0;
        for (const auto& value : pipe_mode(record, k).density)
            power += std::norm(value);
        if (power <= most) continue;
        most = power;
        strongest = k;
    }
    return strongest;
}

/// The bin where the wave of phase exp(-i q (x + 1/2)) summed over `counts` has its crest.
std::size_t crest(std::span<const std::uint16_t> counts,
                  std::span<const std::complex<double>> phase, std::size_t k) {
    std::complex<double> sum;
    for (std::size_t i = 0; i < counts.size(); ++i)
        sum += static_cast<double>(counts[i]) * phase[i];
    const auto bins = static_cast<double>(counts.size());
    const double x = -std::arg(sum) / (2 * std::numbers::pi * static_cast<double>(k)) * bins - 0.5;
    return static_cast<std::size_t>(std::lround(x + 2 * bins)) % counts.size();
}

}  // namespace

std::vector<std::vector<double>> PipeProfile::profiles(bool shuffled) const {
    const PipeRecord& record = recorder_.record();
    const std::size_t bins = record.bins, k = strongest_wave(record);
    std::vector<std::complex<double>> phase;
    for (std::size_t i = 0; i < bins; ++i) {
        const double x = (static_cast<double>(i) + 0.5) / static_cast<double>(bins);
        phase.push_back(std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(k) * x));
    }
    std::vector<std::vector<double>> parts;
    for (const FrameBlock& block : equal_blocks(record.frames(), pipe_blocks)) {
        std::vector<double> profile(bins, 0.0);
        for (std::size_t f = block.first; f < block.last; ++f) {
            const auto given = record.count_at(f);
            std::vector<std::uint16_t> counts(given.begin(), given.end());
            if (shuffled) counts = shuffled_bins(given, f);
            const std::size_t first = crest(counts, phase, k) + bins - bins / 2;
            for (std::size_t x = 0; x < bins; ++x)
                profile[x] += counts[(first + x) % bins];
        }
        const double mean =
            std::accumulate(profile.begin(), profile.end(), 0.0) / static_cast<double>(bins);
        for (double& value : profile)
            value = value / mean - 1;
        parts.push_back(std::move(profile));
    }
    return parts;
}

void PipeProfile::finish(Results& results) {
    const PipeRecord& record = recorder_.record();
    if (record.frames() < fewest_pipe_frames) return;
    const auto waves = profiles(false), nulls = profiles(true);
    Series series{.name = "profile",
                  .columns = {"X", "density", "err", "null"},
                  .values = std::vector<std::vector<double>>(4),
                  .units = {"l", "1", "1", "1"}};
    for (std::size_t x = 0; x < record.bins; ++x) {
        std::vector<double> here, null;
        for (std::size_t p = 0; p < waves.size(); ++p) {
            here.push_back(1 + waves[p][x]);
            null.push_back(1 + nulls[p][x]);
        }
        const MeanWithError density = mean_with_error(here);
        const double position = static_cast<double>(x) - static_cast<double>(record.bins / 2);
        series.values[0].push_back(position * record.bin);
        series.values[1].push_back(density.value);
        series.values[2].push_back(density.standard_error);
        series.values[3].push_back(mean_with_error(null).value);
    }
    results.series.push_back(std::move(series));

    std::vector<double> amplitudes, null_amplitudes, excess, steepness;
    std::size_t sharper = 0;
    for (std::size_t p = 0; p < waves.size(); ++p) {
        amplitudes.push_back(std::ranges::max(waves[p]));
        null_amplitudes.push_back(std::ranges::max(nulls[p]));
        excess.push_back(amplitudes.back() - null_amplitudes.back());
        const auto shape = wave_shape(waves[p]);
        if (!shape) continue;
        steepness.push_back(std::log(shape->steepness));
        if (shape->steepness > 1) ++sharper;
    }
    auto& out = results.measurements;
    out.push_back(over_replicas("profile_amplitude", amplitudes, "1"));
    out.push_back(over_replicas("profile_null_amplitude", null_amplitudes, "1"));
    out.push_back(over_replicas("profile_excess", excess, "1"));
    if (steepness.size() < waves.size()) return;
    out.push_back(over_replicas("profile_asymmetry", steepness, "1"));
    out.push_back(fraction("profile_front_sharper", sharper, waves.size()));
}

}  // namespace crossgrain::measure
