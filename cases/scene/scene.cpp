#include "cases/scene/scene.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace crossgrain::scene {

double contact_time(const Scene& scene) {
    const double m = scene.grains.mass;
    const double eta = scene.contact.damping / m;
    const double omega_squared = 2.0 * scene.contact.stiffness / m - eta * eta;
    if (omega_squared <= 0) return std::numeric_limits<double>::infinity();
    return std::numbers::pi / std::sqrt(omega_squared);
}

double height_at(const PrescribedPlate& plate, double t) {
    return plate.height + plate.amplitude * std::cos(2.0 * std::numbers::pi / plate.period * t);
}

double nearest_image(double separation, const std::optional<double>& period) {
    return period ? separation - *period * std::round(separation / *period) : separation;
}

namespace {

std::size_t plate_contacts(const Scene& scene) {
    const double reach =
        scene.plates.touches == PlateContact::surface ? scene.grains.diameter / 2 : 0.0;
    double bottom = -std::numeric_limits<double>::infinity();
    if (scene.plates.bottom) bottom = height_at(*scene.plates.bottom, 0.0);
    double lid = std::numeric_limits<double>::infinity();
    if (const auto* plate = std::get_if<PrescribedPlate>(&scene.plates.lid)) {
        lid = height_at(*plate, 0.0);
    } else if (const auto* free_lid = std::get_if<FreeLid>(&scene.plates.lid)) {
        lid = free_lid->height;
    }
    std::size_t count = 0;
    for (const double y : scene.initial.y) {
        if (y - reach < bottom) ++count;
        if (y + reach > lid) ++count;
    }
    return count;
}

}  // namespace

std::size_t initial_contacts(const Scene& scene) {
    // Once per run and N is at most some thousands: the plain double loop is fast enough.
    const auto& s = scene.initial;
    const double d_squared = scene.grains.diameter * scene.grains.diameter;
    std::size_t count = plate_contacts(scene);
    for (std::size_t i = 0; i < s.x.size(); ++i) {
        for (std::size_t j = i + 1; j < s.x.size(); ++j) {
            const double dx = nearest_image(s.x[i] - s.x[j], scene.periodic_x);
            const double dy = nearest_image(s.y[i] - s.y[j], scene.periodic_y);
            if (dx * dx + dy * dy < d_squared) ++count;
        }
    }
    return count;
}

std::string to_string(Damping value) {
    return value == Damping::full_vector ? "full-vector" : "normal-only";
}

std::string to_string(Clipping value) {
    switch (value) {
    case Clipping::none: return "none";
    case Clipping::all: return "all";
    case Clipping::normal_only: return "normal-only";
    }
    return {};
}

std::string to_string(Spins value) { return value == Spins::off ? "off" : "on"; }

std::string to_string(PlateContact value) {
    return value == PlateContact::centre ? "centre" : "surface";
}

std::string to_string(Integrator value) {
    return value == Integrator::verlet_half_step ? "verlet-half-step" : "verlet-predicted";
}

}  // namespace crossgrain::scene
