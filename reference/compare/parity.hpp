// Largest difference between what two codes made of the same scene, for trajectories that chaos has
// not separated yet, and the number of digits that agree.
#pragma once

#include "cases/measure/results.hpp"

#include <optional>
#include <span>
#include <string>

namespace crossgrain::compare {

/// max over grains and both axes of |a - b|; nothing if sizes or times differ (more than 1e-9
/// relative).
[[nodiscard]] std::optional<double> largest_difference(const measure::Snapshot& a,
                                                       const measure::Snapshot& b);

/// Rows of a series that take part: first column within [from, to].
struct Window {
    double from = -1e300;
    double to = 1e300;
};

/// max over the rows in the window of |a - b| in the named column; nothing if the series have
/// different rows, lack the column, or have no row in the window.
[[nodiscard]] std::optional<double> largest_difference(const measure::Series& a,
                                                       const measure::Series& b,
                                                       const std::string& column,
                                                       const Window& window);

/// -log10(difference/scale), from 0 to 16; 16 for no difference at all. `scale` > 0 is the length
/// that matters, e.g. the diameter.
[[nodiscard]] double matching_digits(double difference, double scale);

/// The series or snapshot with that name or time (relative 1e-9), or null.
[[nodiscard]] const measure::Series* find_series(const measure::Results& results,
                                                 const std::string& name);
[[nodiscard]] const measure::Snapshot* find_snapshot(const measure::Results& results, double time);

}  // namespace crossgrain::compare
