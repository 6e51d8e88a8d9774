// What several estimators of the lattice gas keep of an ensemble: means over a stretch of the run,
// and a curve against time. Errors are the scatter of the replicas, which are independent.
#pragma once

#include "cases/measure/results.hpp"
#include "native/numerics/mean_with_error.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace crossgrain::measure {

/// Mean of a quantity over the frames first..last of a run, replica by replica.
class GasWindow {
  public:
    /// Frames are counted from 0; first <= last.
    GasWindow(std::int64_t first, std::int64_t last, std::size_t replicas);

    /// `samples` has shape (replicas); frames outside the window are passed over.
    void add(std::int64_t frame, std::span<const double> samples);

    /// Shape (replicas); nothing if the run ended before the window did.
    [[nodiscard]] std::optional<std::vector<double>> means() const;

  private:
    std::int64_t first_, last_, seen_ = 0;
    std::vector<double> sums_;
};

/// A quantity against time, mean and standard error over the replicas, at no more than `rows`
/// equally spaced frames.
class GasCurve {
  public:
    GasCurve(std::int64_t frames, std::int64_t rows = 500);

    void add(std::int64_t frame, std::int64_t step, std::span<const double> samples);

    /// Columns "t", `quantity`, "err".
    [[nodiscard]] Series series(const std::string& name, const std::string& quantity,
                                const std::string& unit) const;

  private:
    std::int64_t stride_;
    std::vector<double> times_, values_, errors_;
};

}  // namespace crossgrain::measure
