#include "cases/measure/gas/gas_steady_state.hpp"

#include "cases/measure/waves/over_samples.hpp"
#include "native/numerics/mean_with_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace crossgrain::measure {
namespace {

void require(bool holds, const char* what) {
    if (!holds) throw std::invalid_argument(what);
}

/// Sums of each replica over the bins, for a field of shape (bins, replicas).
template <class T>
void sum_bins(std::span<const T> field, std::vector<double>& sums) {
    std::ranges::fill(sums, 0.0);
    for (std::size_t at = 0; at < field.size(); at += sums.size()) {
        for (std::size_t r = 0; r < sums.size(); ++r)
            sums[r] += field[at + r];
    }
}

}  // namespace

GasSteadyState::GasSteadyState(const scene::GasSampling& sampling, GasSteadyStateOptions options)
    : sampling_(sampling), options_(options),
      replicas_(static_cast<std::size_t>(sampling.replicas)), last_change_(replicas_, 0) {
    require(sampling.fields.count, "the frames have no field \"count\"");
    require(sampling.replicas >= 4, "a state is judged over at least 4 replicas");
    require(sampling.frames() >= 16, "needs at least 16 frames");
    require(sampling.bins() >= 2, "needs at least 2 bins");
    require(options.tolerance > 0 && options.sigmas > 0, "needs tolerance > 0 and sigmas > 0");
    for (std::size_t q = 0; q < quantities; ++q) {
        now_[q].assign(replicas_, 0.0);
        before_[q].assign(replicas_, 0.0);
        for (auto& quarter : sums_[q])
            quarter.assign(replicas_, 0.0);
    }
}

void GasSteadyState::measure(const scene::GasFrame& frame) {
    sum_bins(frame.count, now_[particles]);
    if (sampling_.fields.rests) sum_bins(frame.rests, now_[rests]);
    if (sampling_.fields.momentum) sum_bins(frame.momentum, now_[momentum]);
    std::ranges::fill(now_[contrast], 0.0);
    std::ranges::fill(now_[variance], 0.0);
    const auto bins = static_cast<double>(frame.bins);
    for (std::size_t i = 0; i < frame.bins; ++i) {
        const std::size_t next = i + 1 < frame.bins ? i + 1 : (sampling_.periodic ? 0 : i);
        const auto* here = &frame.count[i * replicas_];
        const auto* there = &frame.count[next * replicas_];
        for (std::size_t r = 0; r < replicas_; ++r) {
            const double deviation = here[r] - now_[particles][r] / bins;
            now_[contrast][r] += std::abs(static_cast<double>(here[r]) - there[r]);
            now_[variance][r] += deviation * deviation / bins;
        }
    }
}

void GasSteadyState::add(const scene::GasFrame& frame) {
    if (!frame.saturated.empty()) {
        saturated_ = static_cast<std::size_t>(
            std::ranges::count_if(frame.saturated, [](std::uint8_t s) { return s != 0; }));
        saturated_step_ = frame.step;
        return;
    }
    measure(frame);
    const auto quarter =
        static_cast<std::size_t>(std::min<std::int64_t>(3, 4 * frame_ / sampling_.frames()));
    ++frames_in_[quarter];
    const bool complete = sampling_.fields.rests && sampling_.fields.momentum;
    for (std::size_t q = 0; q < quantities; ++q) {
        // With rests and momentum known, what merely drifts past is no event.
        const bool counts = complete ? q == particles || q == rests || q == momentum : true;
        for (std::size_t r = 0; r < replicas_; ++r) {
            sums_[q][quarter][r] += now_[q][r];
            if (counts && now_[q][r] != before_[q][r]) last_change_[r] = frame_;
        }
    }
    std::swap(now_, before_);
    ++frame_;
}

GasSteadyState::Drift GasSteadyState::drift(Quantity quantity, std::size_t from,
                                            std::size_t to) const {
    const Quarters& sums = sums_[quantity];
    const auto n_from = static_cast<double>(frames_in_[from]);
    const auto n_to = static_cast<double>(frames_in_[to]);
    std::vector<double> differences(replicas_);
    double mean = 0;
    for (std::size_t r = 0; r < replicas_; ++r) {
        const double early = sums[from][r] / n_from, late = sums[to][r] / n_to;
        differences[r] = late - early;
        mean += (early + late) / 2 / static_cast<double>(replicas_);
    }
    if (mean == 0) return {};
    const numerics::MeanWithError d = numerics::mean_with_error(differences);
    Drift result{.value = d.value / mean, .error = d.standard_error / mean};
    result.beyond = std::abs(result.value) > options_.tolerance &&
                    std::abs(d.value) > options_.sigmas * d.standard_error;
    return result;
}

bool GasSteadyState::clogged() const {
    if (sampling_.periodic) return false;
    const Drift all = drift(particles, 1, 3);
    return all.beyond && drift(particles, 1, 2).value > 0 && drift(particles, 2, 3).value > 0;
}

void GasSteadyState::add_saturation(Results& results) const {
    results.measurements.push_back(fraction("saturated_fraction", saturated_, replicas_));
    results.findings.push_back(
        {.name = "state",
         .label = "saturated",
         .detail = fmt::format("particles at rest exceeded the sites that can hold them at step {} "
                               "in {} of {} replicas",
                               saturated_step_, saturated_, replicas_)});
}

void GasSteadyState::finish(Results& results) {
    if (saturated_ > 0) return add_saturation(results);
    if (frame_ < sampling_.frames()) return;
    const auto still = static_cast<std::size_t>(std::ranges::count_if(
        last_change_, [&](std::int64_t last) { return last <= frame_ - frame_ / 4; }));
    results.measurements.push_back(fraction("absorbing_fraction", still, replicas_));
    static constexpr std::array<std::pair<Quantity, const char*>, 4> watched{
        {{particles, "particles"},
         {rests, "rests"},
         {contrast, "contrast"},
         {variance, "variance"}}};
    std::string detail;
    bool ageing = false;
    for (const auto& [quantity, word] : watched) {
        if (quantity == particles && sampling_.periodic) continue;
        const Drift d = drift(quantity, 0, 3);
        if (d.value == 0 && d.error == 0) continue;
        ageing = ageing || d.beyond;
        results.measurements.push_back({.observable = fmt::format("drift_{}", word),
                                        .value = d.value,
                                        .standard_error = d.error,
                                        .n = replicas_});
        detail += fmt::format("{}{} {:+.2g} +- {:.2g}", detail.empty() ? "" : ", ", word, d.value,
                              d.error);
    }
    detail =
        detail.empty() ? "nothing changes" : "relative drift from first to last quarter: " + detail;
    if (2 * still > replicas_) {
        detail = fmt::format("nothing happens during the last quarter in {} of {} replicas", still,
                             replicas_);
    }
    const char* label = 2 * still > replicas_ ? "absorbing"
                        : clogged()           ? "clogged"
                        : ageing              ? "ageing"
                                              : "steady";
    results.findings.push_back({.name = "state", .label = label, .detail = detail});
}

}  // namespace crossgrain::measure
