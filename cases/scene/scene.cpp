#include "cases/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace crossgrain::scene {

double largest_diameter(const Grains& grains) {
    return grains.differ() ? *std::max_element(grains.diameters.begin(), grains.diameters.end())
                           : grains.diameter;
}

double contact_time(const Scene& scene) {
    const double m = scene.grains.mass;
    // Per unit of the effective mass m/2, or as it is.
    const bool absolute = scene.contact.damping_scale == DampingScale::absolute;
    const double eta = absolute ? scene.contact.damping / m : scene.contact.damping / 2;
    const double omega_squared = 2.0 * scene.contact.stiffness / m - eta * eta;
    if (omega_squared <= 0) return std::numeric_limits<double>::infinity();
    return std::numbers::pi / std::sqrt(omega_squared);
}

double phase_angle(const PrescribedPlate& plate) {
    return 2.0 * std::numbers::pi * plate.phase;
}

double height_at(const PrescribedPlate& plate, double t) {
    const double angle = 2.0 * std::numbers::pi / plate.period * t + phase_angle(plate);
    return plate.height + plate.amplitude * std::cos(angle);
}

double nearest_image(double separation, const std::optional<double>& period) {
    return period ? separation - *period * std::round(separation / *period) : separation;
}

namespace {

std::size_t plate_contacts(const Scene& scene) {
    const bool surface = scene.plates.touches == PlateContact::surface;
    double bottom = -std::numeric_limits<double>::infinity();
    if (scene.plates.bottom) bottom = height_at(*scene.plates.bottom, 0.0);
    double lid = std::numeric_limits<double>::infinity();
    if (const auto* plate = std::get_if<PrescribedPlate>(&scene.plates.lid)) {
        lid = height_at(*plate, 0.0);
    } else if (const auto* free_lid = std::get_if<FreeLid>(&scene.plates.lid)) {
        lid = free_lid->height;
    }
    std::size_t count = 0;
    for (std::size_t i = 0; i < scene.grain_count(); ++i) {
        const double y = scene.initial.y[i];
        const double reach = surface ? scene.grains.diameter_of(i) / 2 : 0.0;
        if (y - reach < bottom) ++count;
        if (y + reach > lid) ++count;
    }
    return count;
}

/// A grain, or its periodic image above the box, in the order of heights.
struct Site {
    double y = 0;
    std::size_t grain = 0;
};

std::vector<Site> sites_by_height(const Scene& scene) {
    std::vector<Site> sites;
    for (std::size_t i = 0; i < scene.initial.y.size(); ++i) {
        double y = scene.initial.y[i];
        if (scene.periodic_y) y -= *scene.periodic_y * std::floor(y / *scene.periodic_y);
        sites.push_back({y, i});
        if (scene.periodic_y && y < largest_diameter(scene.grains)) {
            sites.push_back({y + *scene.periodic_y, i});
        }
    }
    std::sort(sites.begin(), sites.end(), [](const Site& a, const Site& b) { return a.y < b.y; });
    return sites;
}

/// Two that never move have nothing to do with each other.
bool both_frozen(const InitialState& s, std::size_t i, std::size_t j) {
    return !s.frozen.empty() && s.frozen[i] && s.frozen[j];
}

bool touch(const Scene& scene, const Site& a, const Site& b) {
    const auto& x = scene.initial.x;
    const double dx = nearest_image(x[a.grain] - x[b.grain], scene.periodic_x);
    const double dy = a.y - b.y;
    const double d = (scene.grains.diameter_of(a.grain) + scene.grains.diameter_of(b.grain)) / 2;
    return dx * dx + dy * dy < d * d;
}

}  // namespace

std::size_t initial_contacts(const Scene& scene) {
    const double reach = largest_diameter(scene.grains);
    const std::vector<Site> sites = sites_by_height(scene);
    std::size_t count = plate_contacts(scene);
    for (std::size_t a = 0; a < sites.size(); ++a) {
        for (std::size_t b = a + 1; b < sites.size() && sites[b].y - sites[a].y < reach; ++b) {
            if (sites[a].grain == sites[b].grain) continue;
            if (both_frozen(scene.initial, sites[a].grain, sites[b].grain)) continue;
            // Two images meet twice: once inside the box, once above it.
            const bool counted_below = scene.periodic_y && sites[a].y >= *scene.periodic_y;
            if (!counted_below && touch(scene, sites[a], sites[b])) ++count;
        }
    }
    return count;
}

}  // namespace crossgrain::scene
