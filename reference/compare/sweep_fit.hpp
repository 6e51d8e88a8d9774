// What a quantity follows over the variants of a case: power laws, the law of an outlet, the slope
// of a curve. Errors come from the residuals, or, where these are fewer than the points' own errors
// would make them, from those.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace crossgrain::compare {

/// One point of a sweep.
struct SweepPoint {
    double x = 0, y = 0;
    double standard_error = 0;  ///< of y
};

struct SweepEstimate {
    double value = 0, standard_error = 0;
    double degrees_of_freedom = 0;
};

/// a of y = b x^a by least squares of ln y against ln x, all points weighing the same. Nothing for
/// fewer than three points, x or y that are not positive, or x that are all the same.
[[nodiscard]] std::optional<SweepEstimate> fit_exponent(std::span<const SweepPoint> points);

/// y = C (x - k)^(3/2), x an outlet in diameters (Beverloo, Leniger & van de Velde, Chem. Eng. Sci.
/// 15, 260 (1961), in two dimensions), by the straight line y^(2/3) = C^(2/3) (x - k).
struct OutletLaw {
    SweepEstimate factor;  ///< C
    SweepEstimate cut;     ///< k
};
/// Nothing for fewer than three points or y that do not grow with x.
[[nodiscard]] std::optional<OutletLaw> fit_outlet_law(std::span<const SweepPoint> points);

/// n of y = C (x - k)^n with C, k and n free: k in [0, smallest x) is that with the least squares
/// of ln y. Error by the jackknife over the points, which k's correlation with n makes large.
/// Nothing for fewer than five points or those fit_exponent refuses.
[[nodiscard]] std::optional<SweepEstimate> fit_outlet_exponent(std::span<const SweepPoint> points);

/// dy/dx at each point that has neighbours on both sides, by the parabola through the three; shape
/// of the result: (points), nothing at the ends. Points must be ascending in x.
[[nodiscard]] std::vector<std::optional<SweepEstimate>>
local_slopes(std::span<const SweepPoint> points);

}  // namespace crossgrain::compare
