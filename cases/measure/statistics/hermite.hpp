// Cubic between two frames that matches values and derivatives at both ends.
#pragma once

namespace crossgrain::measure {

/// Cubic with values a, b and derivatives va, vb at the ends of an interval of length h, at the
/// fraction s in [0, 1] of it. Error O(h^4) where the fourth derivative exists.
[[nodiscard]] inline double hermite(double s, double h, double a, double va, double b, double vb) {
    const double r = 1 - s;
    return r * r * ((1 + 2 * s) * a + s * h * va) + s * s * ((1 + 2 * r) * b - r * h * vb);
}

/// Its derivative. Error O(h^3).
[[nodiscard]] inline double hermite_slope(double s, double h, double a, double va, double b,
                                          double vb) {
    const double r = 1 - s;
    return 6 * r * s * (b - a) / h + r * (1 - 3 * s) * va + s * (3 * s - 2) * vb;
}

}  // namespace crossgrain::measure
