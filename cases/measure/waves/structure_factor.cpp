#include "cases/measure/waves/structure_factor.hpp"

#include "cases/measure/statistics/power_law.hpp"
#include "native/numerics/mean_with_error.hpp"
#include "native/numerics/median.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

namespace crossgrain::measure {
namespace {

void require(bool holds, const std::string& what) {
    if (!holds) throw std::invalid_argument(what);
}

void append_exponent(std::span<const std::vector<double>> samples, WaveNumbers window,
                     Results& results) {
    const auto min = static_cast<int>(window.min), max = static_cast<int>(window.max);
    const auto slope = slope_of_mean(samples, min, max);
    if (!slope) return;
    double least = slope->value, most = slope->value;
    for (const auto& [low, high] : {std::pair{min, max / 2}, std::pair{2 * min, max}}) {
        const auto other = log_log_slope(mean_spectrum(samples), low, high);
        if (!other) continue;
        least = std::min(least, *other);
        most = std::max(most, *other);
    }
    results.measurements.push_back(
        {.observable = "wave_number_exponent",
         .value = slope->value,
         .standard_error = slope->standard_error,
         .systematic = (most - least) / 2,
         .n = samples.size(),
         .settings = {{"k_min", static_cast<double>(min)}, {"k_max", static_cast<double>(max)}}});
}

}  // namespace

StructureFactor::StructureFactor(FieldShape shape, WaveNumbers window)
    : shape_(shape), window_(window), transform_(shape.bins),
      spectra_(shape.samples, std::vector<double>(shape.bins / 2 + 1, 0.0)) {
    require(shape.samples >= 3, "needs at least 3 samples");
    require(shape.bins >= 16, "needs at least 16 bins");
    require(window.min >= 1 && window.max > window.min &&
                window.max <= static_cast<std::int64_t>(shape.bins / 2),
            fmt::format("needs 1 <= k_min < k_max <= {}, half the bins", shape.bins / 2));
}

/// Of this sample and, if there is one, the next.
void StructureFactor::transform(std::span<const std::uint16_t> counts, std::size_t sample) {
    const bool two = sample + 1 < shape_.samples;
    const auto input = transform_.input();
    std::array<double, 2> sums{0, 0};
    for (std::size_t i = 0; i < shape_.bins; ++i) {
        const std::uint16_t* count = &counts[i * shape_.samples + sample];
        const float second = two ? static_cast<float>(count[1]) : 0.0F;
        input[i] = {static_cast<float>(count[0]), second};
        sums[0] += count[0];
        sums[1] += double{second};
    }
    const auto bins = static_cast<double>(shape_.bins);
    const std::complex<float> mean{static_cast<float>(sums[0] / bins),
                                   static_cast<float>(sums[1] / bins)};
    for (auto& value : input)
        value -= mean;
    transform_.forward();
    std::vector<double> nobody(two ? 0 : shape_.bins / 2 + 1);
    transform_.add_power(spectra_[sample], two ? spectra_[sample + 1] : nobody);
    particles_ += (sums[0] + sums[1]) / static_cast<double>(shape_.samples);
}

void StructureFactor::add(std::span<const std::uint16_t> counts) {
    for (std::size_t s = 0; s < shape_.samples; s += 2)
        transform(counts, s);
}

std::vector<double> StructureFactor::at(std::size_t k) const {
    std::vector<double> values;
    for (const auto& spectrum : spectra_) {
        // <|n_k|^2>/(K nbar) = (sum over fields)/(particles of all fields).
        if (particles_ > 0) values.push_back(spectrum[k] / particles_);
    }
    return values;
}

void StructureFactor::append(Results& results) const {
    if (particles_ == 0) return;
    constexpr double level = 1e-3, least_ratio = 1.3;
    append_exponent(spectra_, window_, results);
    Series series{.name = "wave-numbers", .columns = {"k", "S", "err"}, .values = {{}, {}, {}}};
    for (std::size_t k = 1; k <= shape_.bins / 2; ++k) {
        const numerics::MeanWithError s = numerics::mean_with_error(at(k));
        series.values[0].push_back(static_cast<double>(k));
        series.values[1].push_back(s.value);
        series.values[2].push_back(s.standard_error);
    }
    const auto& s = series.values[1];
    const auto top = static_cast<std::size_t>(std::ranges::max_element(s) - s.begin());
    const boost::math::students_t student(static_cast<double>(shape_.samples) - 1);
    const double errors = boost::math::quantile(
        boost::math::complement(student, level / static_cast<double>(s.size())));
    if (s[top] - errors * series.values[2][top] > least_ratio * numerics::median(s)) {
        results.measurements.push_back({.observable = "wave_number",
                                        .value = series.values[0][top],
                                        .systematic = 0.5,
                                        .n = shape_.samples,
                                        .unit = "1/L"});
    }
    results.series.push_back(std::move(series));
}

}  // namespace crossgrain::measure
