#include "cases/measure/gas/gas_spectrum.hpp"

#include "cases/measure/gas/gas_record.hpp"
#include "cases/measure/waves/over_samples.hpp"
#include "native/base/memory_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace crossgrain::measure {
namespace {

void require(bool holds, const std::string& what) {
    if (!holds) throw std::invalid_argument(what);
}

/// Fills in the defaults that depend on the pipe, and refuses what makes no sense.
GasSpectrumOptions checked(const scene::GasSampling& sampling, GasSpectrumOptions o) {
    require(sampling.fields.count, "the frames have no field \"count\"");
    require(o.segments >= 1 && o.points >= 64 && o.points % 2 == 0,
            "needs segments >= 1 and an even number of points >= 64");
    require(o.segments * o.points <= sampling.frames(),
            fmt::format("the series of {} frames is shorter than {} segments of {} points",
                        sampling.frames(), o.segments, o.points));
    require(o.f_min > 0 && 2 * o.f_min < o.f_max && o.f_max <= 0.5,
            "needs 0 < 2 f_min < f_max <= 0.5 (cycles per record)");
    require(o.v_min > 0 && o.v_max > o.v_min, "needs 0 < v_min < v_max");
    require(o.running_mean >= 0 && o.running_mean < o.points,
            "running_mean must be from 0 to the number of points");
    if (o.last_bin < 0) o.last_bin = sampling.bins() - 1;
    require(o.first_bin >= 0 && o.first_bin <= o.last_bin && o.last_bin < sampling.bins(),
            fmt::format("needs 0 <= first_bin <= last_bin < {} bins", sampling.bins()));
    require_memory(4.0 * static_cast<double>(o.last_bin - o.first_bin + 2) * sampling.replicas *
                       static_cast<double>(o.points),
                   "segments of all bins and replicas");
    return o;
}

BinRange bins_of(const GasSpectrumOptions& o) {
    return {static_cast<std::size_t>(o.first_bin), static_cast<std::size_t>(o.last_bin)};
}

}  // namespace

GasSpectrum::GasSpectrum(const scene::GasSampling& sampling, GasSpectrumOptions options)
    : options_(checked(sampling, options)), replicas_(static_cast<std::size_t>(sampling.replicas)),
      segments_(bins_of(options_), replicas_, static_cast<std::size_t>(options_.points)),
      bins_(bins_of(options_), replicas_, static_cast<std::size_t>(options_.points),
            static_cast<std::size_t>(options_.running_mean)) {
    const BinnedRecord record = gas_record(sampling);
    const bool whole = bins_of(options_).size() == record.shape.bins;
    if (!sampling.periodic || !whole || record.shape.bins <= 2 * ModeSpectrum::modes) return;
    modes_.emplace(record, static_cast<std::size_t>(options_.points),
                   SpeedBand{options_.v_min, options_.v_max});
}

void GasSpectrum::add(const scene::GasFrame& frame) {
    if (done_ == options_.segments || !segments_.add(frame.count)) return;
    bins_.add(segments_);
    if (modes_) modes_->add(segments_);
    ++done_;
}

void GasSpectrum::finish(Results& results) {
    if (done_ < options_.segments) return;
    double f_max = options_.f_max;
    if (modes_) {
        std::size_t waves = 0;
        for (std::size_t r = 0; r < replicas_; ++r)
            waves += modes_->wave_of(r) ? 1 : 0;
        results.measurements.push_back(fraction("wave_fraction", waves, replicas_));
        if (const auto wave = modes_->append_wave(results)) {
            f_max = std::min(f_max, 0.7 * wave->fundamental);
            results.measurements.back().settings.insert(
                {{"v_min", options_.v_min}, {"v_max", options_.v_max}});
        }
    }
    bins_.append_alpha({options_.f_min, f_max},
                       {{"f_min", options_.f_min},
                        {"f_max", f_max},
                        {"segments", static_cast<double>(options_.segments)},
                        {"points", static_cast<double>(options_.points)},
                        {"running_mean", static_cast<double>(options_.running_mean)}},
                       results);
    bins_.append_series({1, "1/record", "particles^2 records"}, results);
}

}  // namespace crossgrain::measure
