#include "cases/measure/statistics/shift_line.hpp"

#include "native/numerics/line_fit.hpp"

#include <cmath>

namespace crossgrain::measure {

ShiftLine shift_line(std::span<const double> times, std::span<const double> shifts,
                     double smoothing) {
    const numerics::Line line = numerics::line_through(times, shifts);
    bool straight = std::abs(line.intercept) <= smoothing;
    for (std::size_t k = 0; k < times.size(); ++k)
        straight = straight && std::abs(shifts[k] - line.at(times[k])) <= smoothing;
    const double covered = std::abs(line.slope) * (times.back() - times.front());
    return {line.slope, straight && covered > smoothing};
}

}  // namespace crossgrain::measure
