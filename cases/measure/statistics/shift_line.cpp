#include "cases/measure/statistics/shift_line.hpp"

#include <cmath>

namespace crossgrain::measure {

ShiftLine shift_line(std::span<const double> times, std::span<const double> shifts,
                     double smoothing) {
    const auto n = static_cast<double>(times.size());
    double t = 0, x = 0, tt = 0, tx = 0;
    for (std::size_t k = 0; k < times.size(); ++k) {
        t += times[k] / n;
        x += shifts[k] / n;
    }
    for (std::size_t k = 0; k < times.size(); ++k) {
        tt += (times[k] - t) * (times[k] - t);
        tx += (times[k] - t) * (shifts[k] - x);
    }
    const double slope = tx / tt, intercept = x - slope * t;
    bool straight = std::abs(intercept) <= smoothing;
    for (std::size_t k = 0; k < times.size(); ++k)
        straight = straight && std::abs(shifts[k] - intercept - slope * times[k]) <= smoothing;
    const double covered = std::abs(slope) * (times.back() - times.front());
    return {slope, straight && covered > smoothing};
}

}  // namespace crossgrain::measure
