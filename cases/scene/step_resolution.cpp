#include "cases/scene/step_resolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace crossgrain::scene {
namespace {

struct StiffestContact {
    const char* name = "";
    double frequency = 0;

    void consider(const char* other, double stiffness, double effective_mass) {
        const double f = std::sqrt(stiffness / effective_mass);
        if (f > frequency) *this = {other, f};
    }
};

/// Masses of the grains that move, in ascending order; a frozen one is infinitely heavy.
std::vector<double> moving_masses(const Scene& scene) {
    std::vector<double> masses;
    for (std::size_t i = 0; i < scene.grain_count(); ++i) {
        const bool frozen = scene.has_frozen_grains() && scene.initial.frozen[i];
        if (!frozen) masses.push_back(scene.grains.mass_of(i));
    }
    std::ranges::sort(masses);
    return masses;
}

}  // namespace

std::optional<std::string> why_not_resolved(const Scene& scene) {
    const std::vector<double> masses = moving_masses(scene);
    if (masses.empty()) return std::nullopt;
    const double lightest = masses.front();
    StiffestContact stiffest;
    if (scene.grain_count() > 1) {
        // Of the pair that is there: the lightest with the next, or with a frozen one.
        const double partner = scene.has_frozen_grains() || masses.size() < 2
                                   ? std::numeric_limits<double>::infinity()
                                   : masses[1];
        stiffest.consider("two grains", scene.contact.stiffness, 1 / (1 / lightest + 1 / partner));
    }
    if (scene.plates.bottom || !std::holds_alternative<std::monostate>(scene.plates.lid))
        stiffest.consider("a grain and a plate", scene.plates.stiffness, lightest);
    if (const auto* lid = std::get_if<FreeLid>(&scene.plates.lid)) {
        stiffest.consider("a grain and the lid", scene.plates.stiffness,
                          1 / (1 / lightest + 1 / lid->mass));
    }
    const bool runge_kutta = scene.integrator == Integrator::runge_kutta_4;
    const double limit = (runge_kutta ? 2 * std::sqrt(2.0) : 2.0) / stiffest.frequency;
    if (!(scene.dt >= limit)) return std::nullopt;
    return fmt::format("dt = {:g} cannot be stable: a contact of {} needs less than {:.3g}",
                       scene.dt, stiffest.name, limit);
}

}  // namespace crossgrain::scene
