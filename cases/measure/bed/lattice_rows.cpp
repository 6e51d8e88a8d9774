#include "cases/measure/bed/lattice_rows.hpp"

#include <cmath>

namespace crossgrain::measure {

std::optional<LatticeRows> lattice_rows(const scene::Scene& scene) {
    const auto& x = scene.initial.x;
    const auto& y = scene.initial.y;
    const double tolerance = 1e-6 * scene.grains.diameter;
    if (!scene.periodic_x || x.empty()) return std::nullopt;
    std::size_t columns = 1;
    while (columns < y.size() && std::abs(y[columns] - y[0]) < tolerance)
        ++columns;
    if (columns < 2 || x.size() % columns != 0) return std::nullopt;
    const double spacing = *scene.periodic_x / static_cast<double>(columns);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const std::size_t first = i - i % columns;
        const double expected = x[first] + spacing * static_cast<double>(i % columns);
        if (std::abs(y[i] - y[first]) > tolerance) return std::nullopt;
        if (std::abs(x[i] - expected) > tolerance) return std::nullopt;
        if (first == i && i > 0 && y[i] <= y[i - 1] + tolerance) return std::nullopt;
    }
    return LatticeRows{.columns = columns, .rows = x.size() / columns};
}

}  // namespace crossgrain::measure
