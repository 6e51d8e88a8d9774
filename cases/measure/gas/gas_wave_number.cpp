#include "cases/measure/gas/gas_wave_number.hpp"

#include "cases/measure/gas/wave_numbers.hpp"
#include "native/numerics/mean_with_error.hpp"
#include "native/numerics/median.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace crossgrain::measure {
namespace {

void require(bool holds, const std::string& what) {
    if (!holds) throw std::invalid_argument(what);
}

GasWaveNumberOptions checked(const scene::GasSampling& sampling, GasWaveNumberOptions o) {
    require(sampling.fields.count, "the frames have no field \"count\"");
    require(sampling.replicas >= 3, "needs at least 3 replicas");
    require(sampling.bins() >= 16, "needs at least 16 bins");
    if (o.k_max == 0) o.k_max = sampling.bins() / 4;
    require(o.k_min >= 1 && o.k_max > o.k_min && o.k_max <= sampling.bins() / 2,
            fmt::format("needs 1 <= k_min < k_max <= {}", sampling.bins() / 2));
    require(o.fields >= 1, "needs at least one field");
    return o;
}

}  // namespace

GasWaveNumber::GasWaveNumber(const scene::GasSampling& sampling, GasWaveNumberOptions options)
    : sampling_(sampling), options_(checked(sampling, options)),
      bins_(static_cast<std::size_t>(sampling.bins())),
      replicas_(static_cast<std::size_t>(sampling.replicas)),
      stride_((sampling.frames() + options_.fields - 1) / options_.fields), transform_(bins_),
      spectra_(replicas_, std::vector<double>(bins_ / 2 + 1, 0.0)), particles_(replicas_, 0.0) {}

/// Of this replica and, if there is one, the next.
void GasWaveNumber::transform(const scene::GasFrame& frame, std::size_t replica) {
    const bool two = replica + 1 < replicas_;
    const auto input = transform_.input();
    std::array<double, 2> sums{0, 0};
    for (std::size_t i = 0; i < bins_; ++i) {
        const std::uint16_t* count = &frame.count[i * replicas_ + replica];
        const float second = two ? static_cast<float>(count[1]) : 0.0F;
        input[i] = {static_cast<float>(count[0]), second};
        sums[0] += count[0];
        sums[1] += static_cast<double>(second);
    }
    const auto bins = static_cast<double>(bins_);
    const std::complex<float> mean{static_cast<float>(sums[0] / bins),
                                   static_cast<float>(sums[1] / bins)};
    for (auto& value : input)
        value -= mean;
    transform_.forward();
    std::vector<double> nobody(two ? 0 : bins_ / 2 + 1);
    transform_.add_power(spectra_[replica], two ? spectra_[replica + 1] : nobody);
    particles_[replica] += sums[0];
    if (two) particles_[replica + 1] += sums[1];
}

void GasWaveNumber::add(const scene::GasFrame& frame) {
    if (!frame.saturated.empty()) return;
    if (frame_++ % stride_ != 0) return;
    ++used_;
    for (std::size_t r = 0; r < replicas_; r += 2)
        transform(frame, r);
}

void GasWaveNumber::finish(Results& results) {
    const double particles = numerics::mean_with_error(particles_).value;
    if (frame_ < sampling_.frames() || particles == 0) return;
    // <|n_k|^2> / (K nbar) = (sum over fields)/(particles of all fields).
    for (auto& spectrum : spectra_) {
        for (double& value : spectrum)
            value /= particles;
    }
    Series series = wave_number_series(spectra_);
    append_wave_number_exponent(spectra_, static_cast<int>(options_.k_min),
                                static_cast<int>(options_.k_max), results);
    const auto& s = series.values[1];
    const auto top = static_cast<std::size_t>(std::ranges::max_element(s) - s.begin());
    if (s[top] - 5 * series.values[2][top] > 1.3 * numerics::median(s)) {
        results.measurements.push_back({.observable = "wave_number",
                                        .value = series.values[0][top],
                                        .systematic = 0.5,
                                        .n = replicas_,
                                        .unit = "1/L"});
    }
    results.series.push_back(std::move(series));
}

}  // namespace crossgrain::measure
