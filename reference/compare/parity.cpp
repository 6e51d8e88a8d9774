#include "reference/compare/parity.hpp"

#include <algorithm>
#include <cmath>

namespace crossgrain::compare {
namespace {

/// A difference that is not a number is as large as can be: it must never pass for agreement.
double widest(double largest, double difference) {
    if (std::isnan(difference)) return HUGE_VAL;
    return std::max(largest, std::abs(difference));
}

bool same_time(double a, double b) {
    return std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(a));
}

std::optional<std::size_t> column_index(const measure::Series& series, const std::string& column) {
    const auto found = std::find(series.columns.begin(), series.columns.end(), column);
    if (found == series.columns.end()) return std::nullopt;
    return static_cast<std::size_t>(found - series.columns.begin());
}

}  // namespace

std::optional<double> largest_difference(const measure::Snapshot& a, const measure::Snapshot& b) {
    if (a.x.empty() || a.x.size() != b.x.size() || a.y.size() != a.x.size() ||
        b.y.size() != b.x.size() || !same_time(a.time, b.time)) {
        return std::nullopt;
    }
    double largest = 0;
    for (std::size_t i = 0; i < a.x.size(); ++i) {
        largest = widest(largest, a.x[i] - b.x[i]);
        largest = widest(largest, a.y[i] - b.y[i]);
    }
    return largest;
}

std::optional<double> largest_difference(const measure::Series& a, const measure::Series& b,
                                         const std::string& column, const Window& window) {
    const auto in_a = column_index(a, column);
    const auto in_b = column_index(b, column);
    if (!in_a || !in_b) return std::nullopt;
    const auto& place_a = a.values.front();
    const auto& place_b = b.values.front();
    if (place_a.size() != place_b.size()) return std::nullopt;
    std::optional<double> largest;
    for (std::size_t row = 0; row < place_a.size(); ++row) {
        if (!same_time(place_a[row], place_b[row])) return std::nullopt;
        if (place_a[row] < window.from || place_a[row] > window.to) continue;
        largest = widest(largest.value_or(0), a.values[*in_a][row] - b.values[*in_b][row]);
    }
    return largest;
}

double matching_digits(double difference, double scale) {
    if (std::isnan(difference)) return 0;
    if (difference <= 0) return 16;
    return std::clamp(-std::log10(difference / scale), 0.0, 16.0);
}

const measure::Series* find_series(const measure::Results& results, const std::string& name) {
    const auto found = std::find_if(results.series.begin(), results.series.end(),
                                    [&](const auto& series) { return series.name == name; });
    return found == results.series.end() ? nullptr : &*found;
}

const measure::Snapshot* find_snapshot(const measure::Results& results, double time) {
    const auto found =
        std::find_if(results.snapshots.begin(), results.snapshots.end(),
                     [&](const auto& snapshot) { return same_time(snapshot.time, time); });
    return found == results.snapshots.end() ? nullptr : &*found;
}

}  // namespace crossgrain::compare
