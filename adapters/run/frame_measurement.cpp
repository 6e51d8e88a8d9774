#include "adapters/run/frame_measurement.hpp"

#include "native/base/errors.hpp"

#include <fmt/format.h>

#include <cmath>

namespace crossgrain::run {

void require_finite(const measure::Results& results) {
    for (const auto& m : results.measurements) {
        if (std::isfinite(m.value) && std::isfinite(m.standard_error) &&
            std::isfinite(m.systematic))
            continue;
        throw TrajectoryError(
            fmt::format("'{}' came out as {} +- {}", m.observable, m.value, m.standard_error));
    }
}

}  // namespace crossgrain::run
