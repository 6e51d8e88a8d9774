#include "cases/measure/pipe/pipe_spectrum.hpp"

#include "cases/measure/pipe/pipe_modes.hpp"

#include <cmath>
#include <stdexcept>

namespace crossgrain::measure {

PipeSpectrum::PipeSpectrum(const scene::Scene& scene, PipeSpectrumOptions options)
    : recorder_(scene, options.record), options_(options) {
    if (options.segments < 2) throw std::invalid_argument("needs segments >= 2");
    if (!(options.low > 0 && options.high > 0 && options.high <= 0.5)) {
        throw std::invalid_argument("needs low > 0 (of the wave's frequency) and 0 < high <= 0.5 "
                                    "(of V/b)");
    }
}

void PipeSpectrum::append_alpha(const BinSpectrum& spectrum, Results& results) const {
    constexpr double least_decades = 0.5;
    const PipeRecord& record = recorder_.record();
    const double speed = std::abs(record.mean_speed()), per_frame = record.interval;
    const ModeSpectrum modes = mode_spectrum(record);
    const auto wave = modes.wave();
    const double f_wave = wave ? static_cast<double>(modes.strongest_mode()) * wave->fundamental
                               : speed / record.length * per_frame;
    const FrequencyWindow window{options_.low * f_wave,
                                 options_.high * speed / record.bin * per_frame};
    const double decades = std::log10(window.high / window.low);
    if (!(decades >= least_decades)) return;
    spectrum.append_alpha(window,
                          {{"f_min", window.low / per_frame},
                           {"f_max", window.high / per_frame},
                           {"decades", decades},
                           {"peak", wave ? f_wave / per_frame : 0.0},
                           {"bin", record.bin}},
                          results);
}

void PipeSpectrum::finish(Results& results) {
    const PipeRecord& record = recorder_.record();
    const auto samples = static_cast<std::size_t>(options_.segments);
    const std::size_t points = record.frames() / samples / 2 * 2;
    if (points < fewest_pipe_frames) return;
    if (const auto refusal = too_coarse_sampling(record)) {
        results.findings.push_back(*refusal);
        return;
    }
    const BinRange all{0, record.bins - 1};
    RecordSegments segment(all, samples, points);
    for (std::size_t t = 0; t < points; ++t)
        segment.add(record.field(samples, t));
    BinSpectrum spectrum(all, samples, points);
    spectrum.add(segment);
    append_alpha(spectrum, results);
    spectrum.append_series({record.interval, "1/t", "grains^2 t"}, results);
}

}  // namespace crossgrain::measure
