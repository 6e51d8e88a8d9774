#include "cases/measure/pipe/pipe_structure.hpp"

#include "cases/measure/gas/wave_numbers.hpp"
#include "cases/measure/pipe/pipe_record.hpp"
#include "cases/measure/statistics/blocking.hpp"
#include "native/numerics/mean_with_error.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

namespace crossgrain::measure {

PipeStructure::PipeStructure(const scene::Scene& scene, PipeStructureOptions options)
    : section_(pipe_section(scene)), options_(options) {
    if (!(options.k_min >= 1 && options.k_max > options.k_min && options.k_max <= 64)) {
        throw std::invalid_argument("needs 1 <= k_min < k_max <= 64");
    }
    power_.resize(static_cast<std::size_t>(std::max<std::int64_t>(32, options.k_max)) + 1);
}

void PipeStructure::add(const scene::Frame& frame) {
    if (frame.time < options_.skip) return;
    std::vector<std::complex<double>> modes(power_.size());
    for (const std::size_t i : section_.mobile) {
        const auto turn = std::polar(1.0, 2 * std::numbers::pi * frame.y[i] / section_.length);
        std::complex<double> factor = 1;
        for (std::size_t k = 1; k < modes.size(); ++k) {
            factor *= turn;
            modes[k] += factor;
        }
    }
    const auto grains = static_cast<double>(section_.mobile.size());
    for (std::size_t k = 1; k < modes.size(); ++k)
        power_[k].push_back(std::norm(modes[k]) / grains);
}

/// Shape (blocks)(k), as power_law.hpp takes samples of a spectrum.
std::vector<std::vector<double>> PipeStructure::block_means() const {
    std::vector<std::vector<double>> means;
    for (const FrameBlock& block : equal_blocks(power_[1].size(), pipe_blocks)) {
        std::vector<double> spectrum(power_.size(), 0.0);
        for (std::size_t k = 1; k < power_.size(); ++k) {
            const auto own = std::span(power_[k]).subspan(block.first, block.last - block.first);
            spectrum[k] = numerics::mean_with_error(own).value;
        }
        means.push_back(std::move(spectrum));
    }
    return means;
}

void PipeStructure::finish(Results& results) {
    if (power_[1].size() < fewest_pipe_frames) return;
    const auto blocks = block_means();
    append_wave_number_exponent(blocks, static_cast<int>(options_.k_min),
                                static_cast<int>(options_.k_max), results);
    const auto first = static_cast<std::size_t>(options_.k_min);
    if (const auto mean = blocked_mean(power_[first])) {
        results.measurements.push_back({.observable = "structure_factor",
                                        .value = mean->value,
                                        .standard_error = mean->standard_error,
                                        .n = mean->blocks,
                                        .settings = {{"k", static_cast<double>(first)}}});
    }
    Series series = wave_number_series(blocks);
    const auto& s = series.values[1];
    const auto top = static_cast<std::size_t>(std::ranges::max_element(s) - s.begin());
    results.measurements.push_back({.observable = "wave_number",
                                    .value = series.values[0][top],
                                    .systematic = 0.5,
                                    .n = pipe_blocks,
                                    .unit = "1/L"});
    results.series.push_back(std::move(series));
}

}  // namespace crossgrain::measure
