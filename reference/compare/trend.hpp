// Whether a quantity stays the same, grows or falls along a parameter, by statistics.
#pragma once

#include "reference/compare/verdict.hpp"

#include <span>
#include <string>

namespace crossgrain::compare {

enum class Trend { constant, increasing, decreasing };

struct TrendPoint {
    double at = 0;  ///< the parameter
    double value = 0;
    double standard_error = 0;  ///< >= 0
    double degrees_of_freedom = 0;
};

struct TrendAnswer {
    Outcome outcome = Outcome::undecided;  ///< agree, disagree or undecided
    double difference = 0;                 ///< of the pair that decides: later minus earlier
    double half_width_95 = 0;              ///< of that difference
    std::string reason;
};

/// `constant`: agree if every pair of points is equivalent within the margin (two one-sided tests;
/// an intersection of tests needs no correction); disagree if some pair differs by more than the
/// margin at 95 %, corrected for the number of pairs (Bonferroni).
/// `increasing`, `decreasing`: about the last point against the first: agree if it changed the
/// right way by more than the margin (the smallest change that counts) at 95 %, disagree if at 95 %
/// it did not.
/// Throws std::invalid_argument for fewer than two points, numbers that are not finite, a negative
/// margin, or a zero margin for `constant`.
[[nodiscard]] TrendAnswer judge_trend(Trend trend, std::span<const TrendPoint> points,
                                      double margin);

}  // namespace crossgrain::compare
