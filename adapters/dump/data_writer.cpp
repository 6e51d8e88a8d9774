#include "adapters/dump/data_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace crossgrain::adapters::dump {

namespace {

/// The box along one axis: the period, or an interval that holds all positions with room to spare.
std::pair<double, double> bounds(const std::optional<double>& period, std::vector<double> values,
                                 std::optional<double> extra, double margin) {
    if (period) return {0.0, *period};
    if (extra) values.push_back(*extra);
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return {*low - margin, *high + margin};
}

void append_box(fmt::memory_buffer& text, const scene::Scene& scene) {
    std::optional<double> lid;
    if (scene.has_free_lid()) lid = std::get<scene::FreeLid>(scene.plates.lid).height;
    const double d = scene.grains.diameter;
    const auto [x_low, x_high] = bounds(scene.periodic_x, scene.initial.x, {}, d);
    const auto [y_low, y_high] = bounds(scene.periodic_y, scene.initial.y, lid, d);
    // Flat in z; half a diameter on each side keeps every disc inside.
    fmt::format_to(std::back_inserter(text),
                   "{:.17g} {:.17g} xlo xhi\n{:.17g} {:.17g} ylo yhi\n{:.17g} {:.17g} zlo zhi\n",
                   x_low, x_high, y_low, y_high, -d / 2, d / 2);
}

}  // namespace

AtomTypes atom_types(const scene::Scene& scene) {
    AtomTypes types;
    const auto& frozen = scene.initial.frozen;
    if (std::find(frozen.begin(), frozen.end(), true) != frozen.end()) types.frozen = 2;
    if (scene.has_free_lid()) types.lid = types.frozen > 0 ? 3 : 2;
    return types;
}

std::string data_file(const scene::Scene& scene) {
    const AtomTypes types = atom_types(scene);
    const auto& s = scene.initial;
    const std::size_t n = scene.grain_count();
    const auto is_frozen = [&](std::size_t i) { return types.frozen > 0 && s.frozen[i]; };
    fmt::memory_buffer text;
    auto end = std::back_inserter(text);
    fmt::format_to(end, "a scene of crossgrain\n\n{} atoms\n{} atom types\n",
                   n + (types.lid > 0 ? 1 : 0), types.count());
    append_box(text, scene);
    fmt::format_to(end, "\nAtoms\n\n");
    for (std::size_t i = 0; i < n; ++i) {
        fmt::format_to(end, "{} {} {:.17g} 1 {:.17g} {:.17g} 0\n", i + 1,
                       is_frozen(i) ? types.frozen : types.grain, scene.grains.diameter_of(i),
                       s.x[i], s.y[i]);
    }
    if (types.lid > 0) {
        // Above the first grain, where the box is; where along x does not matter.
        fmt::format_to(end, "{} {} {:.17g} 1 {:.17g} {:.17g} 0\n", n + 1, types.lid,
                       scene.grains.diameter, s.x.front(),
                       std::get<scene::FreeLid>(scene.plates.lid).height);
    }
    fmt::format_to(end, "\nVelocities\n\n");
    for (std::size_t i = 0; i < n; ++i) {
        const double omega = is_frozen(i) || s.omega.empty() ? 0.0 : s.omega[i];
        fmt::format_to(end, "{} {:.17g} {:.17g} 0 0 0 {:.17g}\n", i + 1,
                       is_frozen(i) ? 0.0 : s.vx[i], is_frozen(i) ? 0.0 : s.vy[i], omega);
    }
    if (types.lid > 0) {
        fmt::format_to(end, "{} 0 {:.17g} 0 0 0 0\n", n + 1,
                       std::get<scene::FreeLid>(scene.plates.lid).velocity);
    }
    return fmt::to_string(text);
}

}  // namespace crossgrain::adapters::dump
