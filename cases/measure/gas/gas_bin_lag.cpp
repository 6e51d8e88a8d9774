#include "cases/measure/gas/gas_bin_lag.hpp"

#include "cases/measure/waves/field_shift.hpp"
#include "native/numerics/jackknife.hpp"
#include "native/numerics/mean_with_error.hpp"

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace crossgrain::measure {
namespace {

constexpr double clear_transport = 5;  // standard errors
constexpr std::size_t nobody = static_cast<std::size_t>(-1);

}  // namespace

GasBinLag::GasBinLag(const scene::GasSampling& sampling)
    : bins_(static_cast<std::size_t>(sampling.bins())),
      replicas_(static_cast<std::size_t>(sampling.replicas)), same_time_(bins_ * replicas_, 0.0),
      transport_(replicas_, 0.0) {
    if (!sampling.periodic) throw std::invalid_argument("the lag of bins needs a periodic pipe");
    if (!sampling.fields.count) {
        throw std::invalid_argument("the lag of bins needs the field 'count'");
    }
    if (bins_ < 4 || replicas_ < 3) {
        throw std::invalid_argument("the lag of bins needs four bins and three replicas or more");
    }
}

void GasBinLag::add(const scene::GasFrame& frame) {
    before_ = std::exchange(field_, fluctuation({bins_, replicas_}, frame.count, 1));
    ++frames_;
    for (std::size_t i = 0; i < bins_; ++i) {
        const std::size_t here = i * replicas_, next = (i + 1) % bins_ * replicas_;
        for (std::size_t r = 0; r < replicas_; ++r)
            same_time_[here + r] += double{field_[here + r] * field_[next + r]};
        if (frames_ == 1) continue;
        for (std::size_t r = 0; r < replicas_; ++r) {
            transport_[r] +=
                double{before_[here + r] * field_[next + r] - field_[here + r] * before_[next + r]};
        }
    }
}

/// V, or V without one replica.
double GasBinLag::variance_without(std::size_t replica) const {
    const bool all = replica == nobody;
    const double n = static_cast<double>(replicas_) - (all ? 0 : 1);
    double products = 0;
    for (std::size_t i = 0; i < bins_; ++i) {
        const double own = all ? 0 : same_time_[i * replicas_ + replica];
        const double sum = pair_sums_[i] - own;
        products += sum * sum - (pair_squares_[i] - own * own);
    }
    const double per_frame = (transport_sum_ - (all ? 0 : transport_[replica])) / n / 2;
    return products / (n * (n - 1)) / static_cast<double>(bins_) / (per_frame * per_frame);
}

void GasBinLag::finish(Results& results) {
    if (frames_ < 2) return;
    const auto bins = static_cast<double>(bins_);
    for (double& transport : transport_)
        transport /= bins * static_cast<double>(frames_ - 1);
    const numerics::MeanWithError transport = numerics::mean_with_error(transport_);
    if (!(std::abs(transport.value) > clear_transport * transport.standard_error)) return;
    transport_sum_ = std::accumulate(transport_.begin(), transport_.end(), 0.0);
    pair_sums_.assign(bins_, 0.0);
    pair_squares_.assign(bins_, 0.0);
    for (std::size_t r = 0; r < replicas_; ++r) {
        double mean = 0;
        for (std::size_t i = 0; i < bins_; ++i)
            mean += same_time_[i * replicas_ + r] / bins;
        for (std::size_t i = 0; i < bins_; ++i) {
            double& deviation = same_time_[i * replicas_ + r];
            deviation = (deviation - mean) / static_cast<double>(frames_);
            pair_sums_[i] += deviation;
            pair_squares_[i] += deviation * deviation;
        }
    }
    std::vector<double> without;
    for (std::size_t r = 0; r < replicas_; ++r)
        without.push_back(variance_without(r));
    results.measurements.push_back({.observable = "bin_lag_variance",
                                    .value = variance_without(nobody),
                                    .standard_error = numerics::jackknife_error(without),
                                    .n = replicas_,
                                    .unit = "frames^2"});
}

}  // namespace crossgrain::measure
