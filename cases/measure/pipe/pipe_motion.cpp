#include "cases/measure/pipe/pipe_motion.hpp"

#include "cases/measure/statistics/blocking.hpp"
#include "native/numerics/line_fit.hpp"
#include "native/numerics/mean_with_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace crossgrain::measure {
namespace {

/// Error of the difference between last and first quarter that the scatter of eight block means
/// about a straight line makes: waves grow and decay more slowly than blocking within a quarter
/// sees.
double error_of_trend(std::span<const double> series) {
    std::vector<double> means;
    for (const FrameBlock& block : equal_blocks(series.size(), pipe_blocks))
        means.push_back(
            numerics::mean_with_error(series.subspan(block.first, block.last - block.first)).value);
    std::vector<double> blocks(means.size());
    std::iota(blocks.begin(), blocks.end(), 0.0);
    constexpr double blocks_apart = 6;  // middles of the first and the last quarter
    return blocks_apart * numerics::fit_line(blocks, means).slope_error();
}

}  // namespace

PipeMotion::PipeMotion(const scene::Scene& scene, PipeMotionOptions options)
    : options_(options), section_(pipe_section(scene)),
      bins_(PipeRecorder(scene, options.record).record().bins), n_(bins_), vx_(bins_), vy_(bins_),
      vv_(bins_) {
    if (!(options.tolerance > 0 && options.sigmas > 0)) {
        throw std::invalid_argument("needs tolerance > 0 and sigmas > 0");
    }
}

/// Fills the sums by bin; 0 if no bin holds two grains.
double PipeMotion::temperature(const scene::Frame& frame) {
    for (auto* sums : {&n_, &vx_, &vy_, &vv_})
        std::ranges::fill(*sums, 0.0);
    const double per_length = static_cast<double>(bins_) / section_.length;
    for (const std::size_t i : section_.mobile) {
        const auto bin =
            std::min(bins_ - 1, static_cast<std::size_t>(section_.down(frame.y[i]) * per_length));
        n_[bin] += 1;
        vx_[bin] += frame.vx[i];
        vy_[bin] += frame.vy[i];
        vv_[bin] += frame.vx[i] * frame.vx[i] + frame.vy[i] * frame.vy[i];
    }
    double squares = 0, freedom = 0;
    for (std::size_t b = 0; b < bins_; ++b) {
        if (n_[b] < 2) continue;
        squares += vv_[b] - (vx_[b] * vx_[b] + vy_[b] * vy_[b]) / n_[b];
        freedom += 2 * (n_[b] - 1);
    }
    return freedom > 0 ? squares / freedom : 0.0;
}

double PipeMotion::variance() const {
    const double mean = static_cast<double>(section_.mobile.size()) / static_cast<double>(bins_);
    double squares = 0;
    for (const double n : n_)
        squares += (n - mean) * (n - mean);
    return squares / static_cast<double>(bins_);
}

void PipeMotion::add(const scene::Frame& frame) {
    if (frame.time < options_.record.skip) return;
    times_.push_back(frame.time);
    temperature_.push_back(temperature(frame));
    variance_.push_back(variance());
    double speed = 0, spin = 0;
    for (const std::size_t i : section_.mobile) {
        speed -= frame.vy[i];
        if (!frame.omega.empty()) spin += frame.omega[i] * frame.omega[i];
    }
    const auto grains = static_cast<double>(section_.mobile.size());
    speed_.push_back(speed / grains);
    if (!frame.omega.empty()) spin_.push_back(spin / grains);
}

PipeMotion::Drift PipeMotion::drift(std::span<const double> series) const {
    const std::size_t quarter = series.size() / 4;
    const auto early = series.first(quarter), late = series.last(quarter);
    const double from = numerics::mean_with_error(early).value,
                 to = numerics::mean_with_error(late).value;
    const double mean = (from + to) / 2;
    if (mean == 0) return {};
    const auto error_of = [](std::span<const double> part) {
        const auto blocked = blocked_mean(part);
        return blocked ? blocked->standard_error : 0.0;
    };
    const double error =
        std::max(std::hypot(error_of(early), error_of(late)), error_of_trend(series));
    Drift drift{.value = (to - from) / std::abs(mean), .error = error / std::abs(mean)};
    drift.beyond = std::abs(drift.value) > options_.tolerance &&
                   std::abs(drift.value) > options_.sigmas * drift.error;
    return drift;
}

void PipeMotion::append_state(Results& results) const {
    const std::array<std::pair<const char*, const std::vector<double>*>, 3> watched{
        {{"speed", &speed_}, {"temperature", &temperature_}, {"variance", &variance_}}};
    std::string detail = "relative drift from first to last quarter:";
    bool ageing = false;
    for (const auto& [word, series] : watched) {
        const Drift d = drift(*series);
        ageing = ageing || d.beyond;
        results.measurements.push_back({.observable = fmt::format("drift_{}", word),
                                        .value = d.value,
                                        .standard_error = d.error,
                                        .n = times_.size()});
        detail += fmt::format("{} {} {:+.2g} +- {:.2g}", word == watched[0].first ? "" : ",", word,
                              d.value, d.error);
    }
    results.findings.push_back(
        {.name = "state", .label = ageing ? "ageing" : "steady", .detail = std::move(detail)});
}

void PipeMotion::append_series(Results& results) const {
    constexpr std::size_t rows = 1000;
    Series series{.name = "motion",
                  .columns = {"t", "V", "T"},
                  .values = {{}, {}, {}},
                  .units = {"t", "l/t", "l^2/t^2"}};
    const std::size_t stride = (times_.size() + rows - 1) / rows;
    for (std::size_t i = 0; i < times_.size(); i += stride) {
        series.values[0].push_back(times_[i]);
        series.values[1].push_back(speed_[i]);
        series.values[2].push_back(temperature_[i]);
    }
    results.series.push_back(std::move(series));
}

void PipeMotion::finish(Results& results) {
    if (times_.size() < fewest_pipe_frames) return;
    const auto append = [&](const char* name, std::span<const double> series, const char* unit,
                            double factor = 1) {
        const auto mean = blocked_mean(series);
        if (!mean || mean->blocks <= 2) return;  // it drifts: no steady state has a mean
        results.measurements.push_back({.observable = name,
                                        .value = factor * mean->value,
                                        .standard_error = factor * mean->standard_error,
                                        .n = mean->blocks,
                                        .unit = unit,
                                        .settings = {{"skip", options_.record.skip}}});
    };
    append("mean_speed", speed_, "l/t");
    append("flux", speed_, "l/t", section_.area_fraction);
    append("granular_temperature", temperature_, "l^2/t^2");
    append("mean_square_spin", spin_, "1/t^2");
    results.measurements.push_back(
        {.observable = "area_fraction", .value = section_.area_fraction});
    append_state(results);
    append_series(results);
}

}  // namespace crossgrain::measure
