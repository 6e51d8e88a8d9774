#include "cases/measure/pipe/pipe_wave.hpp"

#include "native/numerics/jackknife.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace crossgrain::measure {
namespace {

/// A statistic of the whole run, and of the run without each of its parts.
Measurement jackknifed(const char* observable, double whole,
                       const std::function<double(std::size_t)>& without, const char* unit) {
    std::vector<double> rest;
    for (std::size_t b = 0; b < pipe_blocks; ++b)
        rest.push_back(without(b));
    return {.observable = observable,
            .value = whole,
            .standard_error = numerics::jackknife_error(rest),
            .n = pipe_blocks,
            .unit = unit};
}

FluxRegression sum_of(const std::vector<FluxRegression>& blocks, std::size_t left_out) {
    FluxRegression sum;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        if (b == left_out) continue;
        sum.flux_density += blocks[b].flux_density;
        sum.density_density += blocks[b].density_density;
        sum.self += blocks[b].self;
    }
    return sum;
}

constexpr std::size_t nobody = pipe_blocks;

/// Grains must be correlated over long ways for a pattern: S(k) above 1 by a fifth and by three
/// errors. Of its logarithm: S(k) of a cluster that grows or breaks up goes through decades, and
/// its own error says nothing of how far it is from 1.
bool has_pattern(const std::vector<FluxRegression>& blocks) {
    constexpr double least = 1.2, sigmas = 3;
    const auto log_structure = [&](std::size_t left_out) {
        const FluxRegression sum = sum_of(blocks, left_out);
        return std::log(1 + sum.density_density / sum.self);
    };
    std::vector<double> without;
    for (std::size_t b = 0; b < blocks.size(); ++b)
        without.push_back(log_structure(b));
    return log_structure(nobody) >
           std::max(std::log(least), sigmas * numerics::jackknife_error(without));
}

/// Whether a pattern goes with the grains, by the 95 % interval of V_w/V: an interval too wide to
/// lie near 1 says nothing of the kind.
const char* relative_to_grains(const Measurement& ratio) {
    constexpr double closest = 0.05;
    constexpr double student = 2.365;  // 97.5 %, pipe_blocks - 1 = 7 degrees of freedom
    const double away = std::abs(ratio.value - 1), reach = student * ratio.standard_error;
    if (away + reach < closest) return "carried";
    return away > reach ? "wave" : "undecided";
}

/// Mean velocity of the grains without one block.
double speed_without(const PipeRecord& record, std::size_t left_out) {
    double grains = 0, summed = 0;
    const auto blocks = equal_blocks(record.frames(), pipe_blocks);
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        if (b == left_out) continue;
        // Every frame holds the same grains.
        const auto frames = static_cast<double>(blocks[b].last - blocks[b].first);
        grains += frames;
        summed += frames * record.mean_speed(blocks[b].first, blocks[b].last);
    }
    return summed / grains;
}

}  // namespace

PipeWave::PipeWave(const scene::Scene& scene, PipeWaveOptions options)
    : recorder_(scene, options.record), options_(options) {
    const PipeRecord& record = recorder_.record();
    const double shortest = options.wavelength_min * record.diameter;
    if (!(shortest >= 4 * record.bin && shortest <= record.length)) {
        throw std::invalid_argument(
            fmt::format("wavelength_min must be from four bins to the whole pipe ({:g} to {:g} "
                        "diameters), not {}",
                        4 * record.bin / record.diameter, record.length / record.diameter,
                        options.wavelength_min));
    }
    (void)pipe_overlap(record, options.overlap);  // its options are checked before the run
}

void PipeWave::append_ratios(const OverlapVelocity& overlap,
                             const std::vector<FluxRegression>& regression,
                             Results& results) const {
    const PipeRecord& record = recorder_.record();
    const double velocity = overlap.line().slope, speed = record.mean_speed();
    std::vector<double> velocities;
    for (std::size_t b = 0; b < pipe_blocks; ++b)
        velocities.push_back(overlap.line_without(b).slope);
    const Measurement ratio = jackknifed(
        "wave_over_speed", velocity / speed,
        [&](std::size_t b) { return velocities[b] / speed_without(record, b); }, "1");
    results.measurements.push_back(ratio);
    results.measurements.push_back(jackknifed(
        "wave_over_flux_slope", velocity / sum_of(regression, nobody).slope(),
        [&](std::size_t b) { return velocities[b] / sum_of(regression, b).slope(); }, "1"));
    results.findings.push_back(
        {.name = "wave",
         .label = relative_to_grains(ratio),
         .detail = fmt::format("V_w/V = {:.3f} +- {:.3f}", ratio.value, ratio.standard_error)});
}

void PipeWave::append_overlap(Results& results) const {
    const PipeRecord& record = recorder_.record();
    const auto regression = flux_regression(record, options_.wavelength_min * record.diameter);
    const bool pattern = has_pattern(regression);
    if (pattern) {
        Measurement slope = jackknifed(
            "flux_slope", sum_of(regression, nobody).slope(),
            [&](std::size_t b) { return sum_of(regression, b).slope(); }, "l/t");
        slope.settings = {{"wavelength_min", options_.wavelength_min}};
        results.measurements.push_back(slope);
    }
    const auto overlap = pipe_overlap(record, options_.overlap);
    if (!overlap) return;
    (void)overlap->append_share(results);  // what travels is within the band, whatever its speed
    if (pattern && overlap->append_velocity(results)) {
        append_ratios(*overlap, regression, results);
    } else {
        results.findings.push_back({.name = "wave",
                                    .label = "none",
                                    .detail = pattern
                                                  ? "the shift of greatest overlap does not "
                                                    "follow the interval on a line"
                                                  : "no pattern: grains are not correlated over "
                                                    "long ways"});
    }
}

void PipeWave::finish(Results& results) {
    const PipeRecord& record = recorder_.record();
    if (record.frames() < fewest_pipe_frames) return;
    append_overlap(results);
    results.series.push_back(flux_curve(record, recorder_.section().area_fraction,
                                        options_.wavelength_min * record.diameter));
    if (const auto refusal = too_coarse_sampling(record)) {
        results.findings.push_back(*refusal);
    } else {
        (void)mode_spectrum(record).append_wave(results);
    }
}

}  // namespace crossgrain::measure
