#include "reference/compare/trend.hpp"

#include "reference/compare/equivalence.hpp"
#include "reference/compare/student.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace crossgrain::compare {
namespace {

struct PairDifference {
    const TrendPoint* first;
    const TrendPoint* second;
    double difference;
    double standard_error;
    double degrees_of_freedom;
};

PairDifference pair_of(const TrendPoint& a, const TrendPoint& b) {
    const bool errors_known = a.degrees_of_freedom >= 1 && b.degrees_of_freedom >= 1;
    return {&a, &b, b.value - a.value, std::hypot(a.standard_error, b.standard_error),
            errors_known ? welch_degrees_of_freedom(a.standard_error, a.degrees_of_freedom,
                                                    b.standard_error, b.degrees_of_freedom)
                         : 0.0};
}

/// Half-width of the two-sided interval at error rate `rate`; infinite without degrees of freedom.
double half_width(const PairDifference& pair, double rate) {
    if (pair.standard_error == 0) return 0;
    if (pair.degrees_of_freedom < 1) return INFINITY;
    return student_quantile(1 - rate / 2, pair.degrees_of_freedom) * pair.standard_error;
}

void check(std::span<const TrendPoint> points, double margin) {
    if (points.size() < 2) throw std::invalid_argument("a trend needs two points at least");
    for (const auto& point : points) {
        if (!std::isfinite(point.at) || !std::isfinite(point.value) ||
            !std::isfinite(point.standard_error) || point.standard_error < 0) {
            throw std::invalid_argument("a point of the trend is not a number with an error");
        }
    }
    if (!(margin >= 0) || !std::isfinite(margin)) {
        throw std::invalid_argument("the margin of a trend must be a number >= 0");
    }
}

TrendAnswer judge_constant(const std::vector<TrendPoint>& points, double margin) {
    std::vector<PairDifference> pairs;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = i + 1; j < points.size(); ++j)
            pairs.push_back(pair_of(points[i], points[j]));
    }
    const auto widest =
        *std::max_element(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) {
            return std::abs(a.difference) < std::abs(b.difference);
        });
    TrendAnswer answer{.outcome = Outcome::agree,
                       .difference = widest.difference,
                       .half_width_95 = half_width(widest, 0.05)};
    for (const auto& pair : pairs) {
        const auto same = equivalence({.difference = pair.difference,
                                       .standard_error = pair.standard_error,
                                       .degrees_of_freedom = pair.degrees_of_freedom,
                                       .margin = margin});
        const double corrected = half_width(pair, 0.05 / static_cast<double>(pairs.size()));
        if (std::abs(pair.difference) - corrected > margin) {
            return {.outcome = Outcome::disagree,
                    .difference = pair.difference,
                    .half_width_95 = half_width(pair, 0.05),
                    .reason = fmt::format("changes by {:.3g} between {:g} and {:g}",
                                          pair.difference, pair.first->at, pair.second->at)};
        }
        if (same.outcome != Outcome::agree) answer.outcome = Outcome::undecided;
    }
    if (answer.outcome == Outcome::undecided) {
        answer.reason = "constancy within the margin is neither shown nor excluded";
    }
    return answer;
}

TrendAnswer judge_change(Trend trend, const std::vector<TrendPoint>& points, double margin) {
    const PairDifference ends = pair_of(points.front(), points.back());
    const double sign = trend == Trend::increasing ? 1 : -1;
    TrendAnswer answer{.difference = ends.difference, .half_width_95 = half_width(ends, 0.05)};
    const double change = sign * ends.difference;
    if (change - answer.half_width_95 > margin) {
        answer.outcome = Outcome::agree;
    } else if (change + answer.half_width_95 < margin) {
        answer.outcome = Outcome::disagree;
        answer.reason = fmt::format("{} between {:g} and {:g}, not the trend of the reference",
                                    change < -answer.half_width_95 ? "changes the other way"
                                                                   : "does not change enough",
                                    ends.first->at, ends.second->at);
    } else {
        answer.reason = "the change is neither shown nor excluded";
    }
    return answer;
}

}  // namespace

TrendAnswer judge_trend(Trend trend, std::span<const TrendPoint> points, double margin) {
    check(points, margin);
    std::vector<TrendPoint> ordered(points.begin(), points.end());
    std::sort(ordered.begin(), ordered.end(),
              [](const auto& a, const auto& b) { return a.at < b.at; });
    return trend == Trend::constant ? judge_constant(ordered, margin)
                                    : judge_change(trend, ordered, margin);
}

}  // namespace crossgrain::compare
