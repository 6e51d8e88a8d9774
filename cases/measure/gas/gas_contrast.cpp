#include "cases/measure/gas/gas_contrast.hpp"

#include "cases/measure/waves/over_samples.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <stdexcept>

namespace crossgrain::measure {
namespace {

constexpr double moving_states = 6;

// C_white / K for nbar particles in a bin of `sites` sites.
double white_contrast(double nbar, double sites) {
    const double filling = nbar / sites / moving_states;
    if (nbar <= 0 || filling >= 1) return 0;
    return 2 * std::numbers::inv_sqrtpi * std::sqrt((1 - filling) / nbar);
}

double sites_per_bin(const scene::GasSampling& sampling) {
    return static_cast<double>(sampling.width) * sampling.bin;
}

}  // namespace

GasContrast::GasContrast(const scene::GasSampling& sampling)
    : sampling_(sampling), contrast_(static_cast<std::size_t>(sampling.replicas)),
      differences_(contrast_.size()), totals_(contrast_.size()),
      late_(sampling.frames() * 3 / 4, sampling.frames() - 1, contrast_.size()),
      late_density_(sampling.frames() * 3 / 4, sampling.frames() - 1, contrast_.size()),
      curve_(sampling.frames()), white_curve_(sampling.frames()) {
    if (!sampling.fields.count) throw std::invalid_argument("the contrast needs the field 'count'");
    if (sampling.bins() < 3) throw std::invalid_argument("the contrast needs three bins or more");
}

void GasContrast::measure(const scene::GasFrame& frame) {
    const std::size_t replicas = frame.replicas, bins = frame.bins;
    std::ranges::fill(differences_, 0.0);
    std::ranges::fill(totals_, 0.0);
    const std::size_t pairs = sampling_.periodic ? bins : bins - 1;
    for (std::size_t i = 0; i < bins; ++i) {
        const auto here = frame.count.subspan(i * replicas, replicas);
        const auto next = frame.count.subspan((i + 1) % bins * replicas, replicas);
        for (std::size_t r = 0; r < replicas; ++r) {
            totals_[r] += here[r];
            if (i < pairs) differences_[r] += std::abs(int{here[r]} - int{next[r]});
        }
    }
    for (std::size_t r = 0; r < replicas; ++r) {
        const double nbar = totals_[r] / static_cast<double>(bins);
        contrast_[r] = nbar > 0 ? differences_[r] / static_cast<double>(pairs) / nbar : 0.0;
        totals_[r] = nbar;
    }
}

void GasContrast::add(const scene::GasFrame& frame) {
    measure(frame);
    if (frame_ == 0) first_ = contrast_;
    late_.add(frame_, contrast_);
    late_density_.add(frame_, totals_);
    const auto bins = static_cast<double>(frame.bins);
    std::ranges::transform(contrast_, contrast_.begin(), [&](double c) { return c * bins; });
    std::ranges::transform(totals_, totals_.begin(), [&](double nbar) {
        return bins * white_contrast(nbar, sites_per_bin(sampling_));
    });
    curve_.add(frame_, frame.step, contrast_);
    white_curve_.add(frame_, frame.step, totals_);
    ++frame_;
}

void GasContrast::finish(Results& results) {
    if (frame_ == 0) return;
    Series series = curve_.series("contrast", "C", "1");
    series.columns.emplace_back("C_white");
    series.values.push_back(white_curve_.series("", "", "").values[1]);
    series.units.emplace_back("1");
    results.series.push_back(std::move(series));

    const auto late = late_.means(), density = late_density_.means();
    if (!late) return;
    const double white =
        white_contrast(numerics::mean_with_error(*density).value, sites_per_bin(sampling_));
    const double initial = numerics::mean_with_error(first_).value;
    Measurement level = over_samples("contrast_late", *late, "1");
    level.settings = {{"white", white}, {"initial", initial}};
    results.measurements.push_back(level);

    std::vector<double> growth = *late;
    for (std::size_t r = 0; r < growth.size(); ++r)
        growth[r] -= first_[r];
    results.measurements.push_back(over_samples("contrast_growth", growth, "1"));
    const auto grown = std::ranges::count_if(*late, [&](double c) { return c > initial; });
    results.measurements.push_back(
        fraction("contrast_grows", static_cast<std::size_t>(grown), late->size()));
    if (white > 0) {
        std::vector<double> excess = *late;
        std::ranges::transform(excess, excess.begin(), [&](double c) { return c / white - 1; });
        results.measurements.push_back(over_samples("contrast_excess", excess, "1"));
    }
}

}  // namespace crossgrain::measure
