#include "cases/measure/statistics/spectrum_peak.hpp"

#include "native/numerics/median.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace crossgrain::measure {
namespace {

constexpr std::size_t least_reach = 12;

std::size_t reach(std::size_t k) {
    return std::max(least_reach, k / 5);
}

/// The expectation around one frequency: log P = level + slope (log k' - log k).
struct Background {
    double level = 0, slope = 0, scatter = 0;
};

class Neighbourhoods {
  public:
    explicit Neighbourhoods(std::span<const double> power) {
        for (std::size_t k = 0; k < power.size(); ++k) {
            y_.push_back(std::log(power[k]));
            x_.push_back(std::log(static_cast<double>(std::max<std::size_t>(k, 1))));
        }
        smooth_ = y_;
        for (std::size_t k = 1; k + 1 < power.size(); ++k)
            smooth_[k] = std::log((power[k - 1] + 2 * power[k] + power[k + 1]) / 4);
    }

    [[nodiscard]] Background around(std::size_t k) {
        const std::size_t r = reach(k);
        const double below = half(k - r, k), above = half(k + 1, k + r + 1);
        const double x_below = (x_[k - r] + x_[k - 1]) / 2, x_above = (x_[k + 1] + x_[k + r]) / 2;
        Background b;
        b.slope = (above - below) / (x_above - x_below);
        b.level = below + b.slope * (x_[k] - x_below);
        values_.clear();
        for (std::size_t j = k - r; j <= k + r; ++j) {
            values_.push_back(std::abs(y_[j] - b.level - b.slope * (x_[j] - x_[k])));
        }
        b.scatter = 1.4826 * numerics::median(values_);
        return b;
    }

    /// What lies farther off than a broad peak reaches, and the scatter that is left of it.
    [[nodiscard]] Background farther_off(std::size_t k) {
        Background b;
        b.level = std::max(half(k - k / 2, k - k / 4), half(k + k / 4 + 1, k + k / 2 + 1));
        values_.clear();
        for (std::size_t j = std::max<std::size_t>(k - reach(k), 2); j <= k + reach(k); ++j)
            values_.push_back(std::abs(smooth_[j - 1] - 2 * smooth_[j] + smooth_[j + 1]));
        // (1, 2, 1)/4 after (1, -2, 1): (1, 0, -2, 0, 1)/4, variance 6/16 of that of log P.
        b.scatter = 1.4826 * numerics::median(values_) / std::sqrt(6.0 / 16);
        return b;
    }

    [[nodiscard]] double log_power(std::size_t k) const { return y_[k]; }

  private:
    [[nodiscard]] double half(std::size_t from, std::size_t to) {
        values_.assign(y_.begin() + static_cast<std::ptrdiff_t>(from),
                       y_.begin() + static_cast<std::ptrdiff_t>(to));
        return numerics::median(values_);
    }

    std::vector<double> x_, y_, values_;
    std::vector<double> smooth_;  ///< log of P averaged over neighbours
};

/// Centre of the connected stretch around `top` in which the excess over the background is above a
/// tenth of that at the top, and above three times the scatter. (Half the height would hold one or
/// two frequencies of a sharp line and cost a quarter of a frequency step.)
double centroid(std::span<const double> power, std::size_t top, const Background& background) {
    const auto excess = [&](std::size_t k) {
        const double ratio = static_cast<double>(k) / static_cast<double>(top);
        return power[k] - std::exp(background.level + background.slope * std::log(ratio));
    };
    const double least = std::max(0.1 * excess(top),
                                  std::exp(background.level) * std::expm1(3 * background.scatter));
    double sum = excess(top), moment = 0;
    const auto add = [&](std::size_t k) {
        if (!(excess(k) > least)) return false;
        sum += excess(k);
        moment += excess(k) * (static_cast<double>(k) - static_cast<double>(top));
        return true;
    };
    const std::size_t r = reach(top);
    for (std::size_t k = top + 1; k <= top + r && add(k); ++k) {
    }
    for (std::size_t k = top - 1; k >= top - r && add(k); --k) {
    }
    return static_cast<double>(top) + moment / sum;
}

struct Candidate {
    SpectrumPeak peak;
    std::size_t top = 0;
};

/// The frequency first..last that rises highest above the background that `around` gives for it.
template <class Around>
Candidate highest(std::span<const double> power, std::size_t first, std::size_t last,
                  const Neighbourhoods& neighbourhoods, Around around) {
    std::size_t top = 0;
    double height = -std::numeric_limits<double>::infinity();
    Background background;
    for (std::size_t k = first; k <= last; ++k) {
        const Background b = around(k);
        const double rise = neighbourhoods.log_power(k) - b.level;
        if (rise <= height) continue;
        height = rise;
        top = k;
        background = b;
    }
    SpectrumPeak peak{.k = static_cast<double>(top), .ratio = std::exp(height)};
    if (height > 0) peak.k = centroid(power, top, background);
    peak.sigmas = background.scatter > 0 ? height / background.scatter : 0;
    return {peak, top};
}

}  // namespace

std::optional<SpectrumPeak> find_peak(std::span<const double> power, const PeakSearch& search) {
    const std::size_t first = std::max(search.first, least_reach + 1);
    if (first >= search.last) return std::nullopt;
    if (search.last + reach(search.last) >= power.size()) return std::nullopt;
    Neighbourhoods neighbourhoods(power);
    SpectrumPeak peak = highest(power, first, search.last, neighbourhoods, [&](std::size_t k) {
                            return neighbourhoods.around(k);
                        }).peak;
    peak.significant = peak.sigmas >= search.least_sigma && peak.ratio >= search.least_ratio;
    const bool room = search.last + search.last / 2 < power.size();
    if (peak.significant || !room) return peak;
    auto [broad, summit] = highest(power, first, search.last, neighbourhoods,
                                   [&](std::size_t k) { return neighbourhoods.farther_off(k); });
    // At an end of the band it is the side of something that lies outside.
    broad.significant = summit > first && summit < search.last &&
                        broad.sigmas >= search.least_sigma &&
                        broad.ratio >= search.least_broad_ratio;
    return broad.significant ? broad : peak;
}

}  // namespace crossgrain::measure
