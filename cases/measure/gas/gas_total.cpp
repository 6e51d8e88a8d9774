#include "cases/measure/gas/gas_total.hpp"

#include "cases/measure/waves/over_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace crossgrain::measure {
namespace {

constexpr std::int64_t plateau_from = 4, plateau_to = 6, shortest = 12;  // lengths of the pipe

std::int64_t first_frame_from(const scene::GasSampling& sampling, std::int64_t step) {
    const std::int64_t after = step - sampling.burn_in;
    return after <= 0 ? 0 : (after + sampling.every - 1) / sampling.every;
}

GasWindow plateau_of(const scene::GasSampling& sampling) {
    const std::int64_t first = first_frame_from(sampling, plateau_from * sampling.length);
    const std::int64_t frames = (plateau_to - plateau_from) * sampling.length / sampling.every;
    return {first, first + std::max<std::int64_t>(frames - 1, 0),
            static_cast<std::size_t>(sampling.replicas)};
}

}  // namespace

GasTotal::GasTotal(const scene::GasSampling& sampling, GasTotalOptions options)
    : sampling_(sampling), options_(options), number_(static_cast<std::size_t>(sampling.replicas)),
      outflow_(number_.size()), plateau_(plateau_of(sampling)),
      late_(sampling.frames() * 3 / 4, sampling.frames() - 1, number_.size()),
      late_outflow_(sampling.frames() * 3 / 4, sampling.frames() - 1, number_.size()),
      curve_(sampling.frames()) {
    if (sampling.periodic) {
        throw std::invalid_argument("the number of particles in a periodic pipe does not change");
    }
    if (!sampling.fields.count) throw std::invalid_argument("the total needs the field 'count'");
    if (!(options.margin > 0)) {
        throw std::invalid_argument(fmt::format("margin must be > 0, not {}", options.margin));
    }
    if (sampling.burn_in + sampling.steps < shortest * sampling.length) {
        throw std::invalid_argument(
            fmt::format("the run ends at step {}, a plateau and what follows it need {}",
                        sampling.burn_in + sampling.steps, shortest * sampling.length));
    }
}

void GasTotal::add(const scene::GasFrame& frame) {
    std::ranges::fill(number_, 0.0);
    for (std::size_t i = 0; i < frame.bins; ++i) {
        const auto bin = frame.count.subspan(i * frame.replicas, frame.replicas);
        for (std::size_t r = 0; r < frame.replicas; ++r)
            number_[r] += bin[r];
    }
    plateau_.add(frame_, number_);
    late_.add(frame_, number_);
    curve_.add(frame_, frame.step, number_);
    if (!frame.momentum.empty()) {
        // Unit of momentum 1/2 site per step, summed over the `bin` rows each particle crosses.
        const auto last = frame.momentum.last(frame.replicas);
        for (std::size_t r = 0; r < frame.replicas; ++r)
            outflow_[r] = last[r] / 2.0 / sampling_.bin;
        late_outflow_.add(frame_, outflow_);
    }
    saturated_.assign(frame.saturated.begin(), frame.saturated.end());
    ++frame_;
}

void GasTotal::finish(Results& results) {
    if (frame_ == 0) return;
    results.series.push_back(curve_.series("number", "N", "1"));
    const auto plateau = plateau_.means();
    if (!plateau) return;
    const std::vector<double> late = late_.means().value_or(number_);
    std::vector<double> growth = late;
    std::size_t clogged = 0;
    for (std::size_t r = 0; r < growth.size(); ++r) {
        growth[r] = (*plateau)[r] > 0 ? late[r] / (*plateau)[r] - 1 : 0.0;
        const bool full = r < saturated_.size() && saturated_[r] != 0;
        if (full || growth[r] > options_.margin) ++clogged;
    }
    results.measurements.push_back(over_samples("number_plateau", *plateau, "1"));
    results.measurements.push_back(over_samples("number_late", late, "1"));
    results.measurements.push_back(over_samples("number_growth", growth, "1"));
    Measurement share = fraction("clogged_fraction", clogged, growth.size());
    share.settings = {{"margin", options_.margin}};
    results.measurements.push_back(share);
    const auto outflow = late_outflow_.means();
    if (outflow && sampling_.fields.momentum) {
        results.measurements.push_back(over_samples("outflow", *outflow, "1/step"));
    }
}

}  // namespace crossgrain::measure
