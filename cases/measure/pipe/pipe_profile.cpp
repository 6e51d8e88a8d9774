#include "cases/measure/pipe/pipe_profile.hpp"

#include "cases/measure/pipe/pipe_modes.hpp"
#include "cases/measure/waves/wave_profile.hpp"
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
    const AlignedProfiles aligned{profiles(false), profiles(true)};
    results.series.push_back(profile_series(
        aligned, {.bin = record.bin, .density = 1, .length_unit = "l", .density_unit = "1"}));
    append_profile(aligned, results);
}

}  // namespace crossgrain::measure
