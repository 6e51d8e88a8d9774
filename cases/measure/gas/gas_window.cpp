#include "cases/measure/gas/gas_window.hpp"

#include <algorithm>

namespace crossgrain::measure {

GasWindow::GasWindow(std::int64_t first, std::int64_t last, std::size_t replicas)
    : first_(first), last_(last), sums_(replicas, 0.0) {}

void GasWindow::add(std::int64_t frame, std::span<const double> samples) {
    if (frame < first_ || frame > last_) return;
    ++seen_;
    for (std::size_t r = 0; r < sums_.size(); ++r)
        sums_[r] += samples[r];
}

std::optional<std::vector<double>> GasWindow::means() const {
    if (seen_ < last_ - first_ + 1) return std::nullopt;
    std::vector<double> means = sums_;
    for (double& mean : means)
        mean /= static_cast<double>(seen_);
    return means;
}

GasCurve::GasCurve(std::int64_t frames, std::int64_t rows)
    : stride_(std::max<std::int64_t>(1, (frames + rows - 1) / rows)) {}

void GasCurve::add(std::int64_t frame, std::int64_t step, std::span<const double> samples) {
    if (frame % stride_ != 0) return;
    const numerics::MeanWithError mean = numerics::mean_with_error(samples);
    times_.push_back(static_cast<double>(step));
    values_.push_back(mean.value);
    errors_.push_back(mean.standard_error);
}

Series GasCurve::series(const std::string& name, const std::string& quantity,
                        const std::string& unit) const {
    return {.name = name,
            .columns = {"t", quantity, "err"},
            .values = {times_, values_, errors_},
            .units = {"steps", unit, unit}};
}

}  // namespace crossgrain::measure
