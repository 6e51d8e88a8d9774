#include "cases/measure/waves/spectrum_peak.hpp"

#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace crossgrain::measure {
namespace {

constexpr std::array<std::size_t, 7> widths{1, 3, 7, 15, 31, 63, 127};
constexpr std::size_t least_side = 32, fewest_beside = 3;

double independent(std::size_t width) {
    return static_cast<double>(width) / 1.8 + 0.75;
}

/// A mean over `width` frequencies around `k` and what is expected of it.
struct Candidate {
    std::size_t k = 0, width = 1;
    double background = 0, ratio = 0;
    double degrees = 0, background_degrees = 0;
    /// Log likelihood ratio of a chi^2 against its expectation: 0 without a peak.
    [[nodiscard]] double evidence() const {
        return ratio > 1 ? degrees / 2 * (ratio - 1 - std::log(ratio)) : 0.0;
    }
};

class Search {
  public:
    Search(std::span<const double> power, double degrees)
        : degrees_(degrees), smooth_(power.size()) {
        for (std::size_t k = 1; k + 1 < power.size(); ++k)
            smooth_[k] = (power[k - 1] + 2 * power[k] + power[k + 1]) / 4;
        if (power.size() > 2) smooth_.back() = power.back();
        sums_.push_back(0);
        for (const double value : smooth_)
            sums_.push_back(sums_.back() + value);
        const double nu = degrees * independent(1);
        median_over_mean_ = std::pow(1 - 2 / (9 * nu), 3);
    }

    [[nodiscard]] std::optional<Candidate> at(std::size_t k, std::size_t width) {
        const std::size_t half = width / 2, gap = half + width, side = std::max(least_side, width);
        if (k < gap + 1 + fewest_beside || k + gap + fewest_beside >= smooth_.size()) {
            return std::nullopt;
        }
        const std::size_t from = k - gap > side ? k - gap - side : 1;
        const std::size_t to = std::min(smooth_.size(), k + gap + 1 + side);
        const double background =
            std::max(median(from, k - gap), median(k + gap + 1, to)) / median_over_mean_;
        if (!(background > 0)) return std::nullopt;
        const double mean = (sums_[k + half + 1] - sums_[k - half]) / static_cast<double>(width);
        const auto beside = static_cast<double>((k - gap - from) + (to - k - gap - 1));
        return Candidate{.k = k,
                         .width = width,
                         .background = background,
                         .ratio = mean / background,
                         .degrees = degrees_ * independent(width),
                         .background_degrees = degrees_ * beside / 3};
    }

  private:
    double median(std::size_t from, std::size_t to) {
        values_.assign(smooth_.begin() + static_cast<std::ptrdiff_t>(from),
                       smooth_.begin() + static_cast<std::ptrdiff_t>(to));
        const auto middle = values_.begin() + static_cast<std::ptrdiff_t>(values_.size() / 2);
        std::ranges::nth_element(values_, middle);
        return *middle;
    }

    double degrees_, median_over_mean_ = 1;
    std::vector<double> smooth_, sums_, values_;
};

double false_alarm(const Candidate& candidate, double searched) {
    const boost::math::fisher_f noise(candidate.degrees, candidate.background_degrees);
    const double p = boost::math::cdf(boost::math::complement(noise, candidate.ratio));
    return -std::expm1(searched * std::log1p(-std::min(p, 1 - 1e-16)));
}

/// Centroid of the excess, its error and its sum, in a stretch as wide as the peak and its gaps; a
/// second pass starts from the first one's centroid.
void measure_shape(std::span<const double> power, const Candidate& top, double degrees,
                   SpectrumPeak& peak) {
    const std::size_t reach = top.width / 2 + std::max<std::size_t>(top.width, 2);
    peak.k = static_cast<double>(top.k);
    for (int pass = 0; pass < 2; ++pass) {
        const auto centre = static_cast<std::size_t>(std::lround(peak.k));
        double sum = 0, moment = 0, squares = 0;
        const std::size_t from = centre - std::min(reach, centre - 1);
        const std::size_t to = std::min(power.size(), centre + reach + 1);
        for (std::size_t k = from; k < to; ++k) {
            const double excess = std::max(0.0, power[k] - top.background);
            const double away = static_cast<double>(k) - static_cast<double>(centre);
            sum += excess;
            moment += excess * away;
        }
        if (!(sum > 0)) return;
        peak.k = static_cast<double>(centre) + moment / sum;
        for (std::size_t k = from; k < to; ++k)
            squares += std::pow(power[k] * (static_cast<double>(k) - peak.k), 2);
        peak.k_error = std::sqrt(1.8 * 2 / degrees * squares) / sum;
        peak.excess = sum;
    }
}

}  // namespace

double SpectrumPeak::sigmas() const {
    const double p = std::clamp(false_alarm, 1e-300, 1.0 - 1e-16);
    return boost::math::quantile(boost::math::complement(boost::math::normal(), p));
}

std::optional<SpectrumPeak> find_peak(std::span<const double> power, const PeakSearch& search) {
    Search spectrum(power, search.degrees);
    std::optional<Candidate> top;
    double searched = 0;
    for (const std::size_t width : widths) {
        // Means that overlap by three quarters are enough to meet a peak.
        for (std::size_t k = search.first; k <= search.last; k += width / 4 + 1) {
            const auto candidate = spectrum.at(k, width);
            if (!candidate) continue;
            searched += static_cast<double>(width / 4 + 1) / static_cast<double>(width);
            if (!top || candidate->evidence() > top->evidence()) top = candidate;
        }
    }
    if (!top) return std::nullopt;
    SpectrumPeak peak{.k = static_cast<double>(top->k), .ratio = top->ratio};
    peak.false_alarm = false_alarm(*top, searched * static_cast<double>(search.spectra));
    measure_shape(power, *top, search.degrees, peak);
    // Otherwise it is the side of something that lies outside of the search.
    const bool inside =
        peak.k >= static_cast<double>(search.first) && peak.k <= static_cast<double>(search.last);
    peak.significant =
        inside && peak.false_alarm <= largest_false_alarm && peak.ratio >= least_peak_ratio;
    return peak;
}

}  // namespace crossgrain::measure
