// The velocity of a pattern from the shifts at which later fields overlap an earlier one most
// (Peng & Herrmann 1995, section III.C): the slope of the straight line through shift against
// interval, intercept free.
//
// A pattern travels if its shifts lie on the line: every residual and the intercept within one
// smoothing length of the fields, and more than a smoothing length is covered between the first and
// the last interval.
#pragma once

#include <span>

namespace crossgrain::measure {

struct ShiftLine {
    double slope = 0;
    bool travels = false;
};

/// Ascending `times` and unwrapped `shifts`, both of shape (intervals), at least three.
[[nodiscard]] ShiftLine shift_line(std::span<const double> times, std::span<const double> shifts,
                                   double smoothing);

}  // namespace crossgrain::measure
