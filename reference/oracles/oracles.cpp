#include "reference/oracles/oracles.hpp"

#include "reference/analytic/normal_collision.hpp"
#include "reference/analytic/oblique_collision.hpp"
#include "reference/analytic/plate_bounce.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace crossgrain::oracles {
namespace {

using scene::LatticeGas;
using scene::Scene;
using scene::SyntheticSignal;

/// The first pair of a scene of isolated pairs, as two bodies.
analytic::ObliqueContact contact_of(const Scene& scene) {
    if (scene.contact.friction) throw std::domain_error("no closed form with friction");
    const bool partner_frozen = scene.has_frozen_grains() && scene.initial.frozen.at(1);
    const double partner =
        partner_frozen ? std::numeric_limits<double>::infinity() : scene.grains.mass_of(1);
    const double reduced_mass = analytic::reduced_mass(scene.grains.mass_of(0), partner);
    const bool per_mass = scene.contact.damping_scale == scene::DampingScale::effective_mass;
    return {.stiffness = scene.contact.stiffness,
            .damping = scene.contact.damping * (per_mass ? reduced_mass : 1),
            .reduced_mass = reduced_mass,
            .diameter = (scene.grains.diameter_of(0) + scene.grains.diameter_of(1)) / 2,
            .damping_acts_on = scene.contact.damping_acts_on == scene::Damping::full_vector
                                   ? analytic::Damping::full_vector
                                   : analytic::Damping::normal_only,
            .clipping = static_cast<analytic::Clipping>(scene.contact.clipping)};
}

static_assert(static_cast<int>(analytic::Clipping::none) ==
              static_cast<int>(scene::Clipping::none));
static_assert(static_cast<int>(analytic::Clipping::all) == static_cast<int>(scene::Clipping::all));
static_assert(static_cast<int>(analytic::Clipping::normal_only) ==
              static_cast<int>(scene::Clipping::normal_only));

struct FirstPair {
    double x, y, vx, vy;  ///< of grain 0 relative to grain 1
    [[nodiscard]] double speed() const { return std::hypot(vx, vy); }
    [[nodiscard]] double impact_parameter() const { return std::abs(x * vy - y * vx) / speed(); }
};

FirstPair first_pair(const Scene& scene) {
    const auto& s = scene.initial;
    return {s.x.at(0) - s.x.at(1), s.y.at(0) - s.y.at(1), s.vx.at(0) - s.vx.at(1),
            s.vy.at(0) - s.vy.at(1)};
}

/// The closed form where there is one (head-on), the integrated motion otherwise.
analytic::ObliqueCollision pair_collision(const Scene& scene) {
    const analytic::ObliqueContact contact = contact_of(scene);
    const FirstPair pair = first_pair(scene);
    if (pair.impact_parameter() < 1e-12 * contact.diameter) {
        const auto attraction = contact.clipping == analytic::Clipping::none
                                    ? analytic::Attraction::kept
                                    : analytic::Attraction::cut;
        const auto exact = analytic::normal_collision({.stiffness = contact.stiffness,
                                                       .damping = contact.damping,
                                                       .reduced_mass = contact.reduced_mass},
                                                      attraction);
        analytic::ObliqueCollision result;
        result.restitution = exact.restitution;
        result.contact_time = exact.contact_time;
        result.angular_momentum_ratio = std::numeric_limits<double>::quiet_NaN();
        return result;
    }
    return analytic::oblique_collision(
        contact, {.speed = pair.speed(), .impact_parameter = pair.impact_parameter()});
}

double plate_contact_time(const Scene& scene) {
    analytic::PlateImpact impact{.stiffness = scene.plates.stiffness,
                                 .grain_mass = scene.grains.mass,
                                 .grain_velocity = scene.initial.vy.at(0)};
    if (const auto* lid = std::get_if<scene::FreeLid>(&scene.plates.lid)) {
        impact.plate_mass = lid->mass;
        impact.plate_velocity = lid->velocity;
    }
    return analytic::plate_bounce(impact).contact_time;
}

using Oracle = double (*)(const Scene&);

const std::map<std::string, Oracle>& oracles() {
    static const std::map<std::string, Oracle> all{
        {"analytic:restitution", [](const Scene& s) { return pair_collision(s).restitution; }},
        {"analytic:contact_time", [](const Scene& s) { return pair_collision(s).contact_time; }},
        {"analytic:angular_momentum_ratio",
         [](const Scene& s) { return pair_collision(s).angular_momentum_ratio; }},
        {"analytic:plate_restitution", [](const Scene&) { return 1.0; }},
        {"analytic:plate_contact_time", plate_contact_time},
        // tools/new.sh oracle: entries go above this line
    };
    return all;
}

/// A calibration signal's own parameters are its exact answers.
const std::map<std::string, double (*)(const SyntheticSignal&)>& signal_oracles() {
    static const std::map<std::string, double (*)(const SyntheticSignal&)> all{
        {"analytic:signal_exponent", [](const SyntheticSignal& s) { return s.exponent; }},
        {"analytic:signal_velocity", [](const SyntheticSignal& s) { return s.wave_velocity; }},
    };
    return all;
}

/// What the rules of a lattice gas conserve.
const std::map<std::string, std::optional<double> (*)(const LatticeGas&)>& gas_oracles() {
    static const std::map<std::string, std::optional<double> (*)(const LatticeGas&)> all{
        {"analytic:gas_density",
         [](const LatticeGas& g) {
             return g.ends == scene::PipeEnds::periodic ? std::optional(g.density) : std::nullopt;
         }},
    };
    return all;
}

}  // namespace

std::optional<double> exact_value(const std::string& name, const scene::AnyScene& scene) {
    if (name == "analytic:zero") return 0.0;
    if (const auto* signal = std::get_if<SyntheticSignal>(&scene)) {
        const auto found = signal_oracles().find(name);
        return found == signal_oracles().end() ? std::nullopt
                                               : std::optional(found->second(*signal));
    }
    if (const auto* gas = std::get_if<LatticeGas>(&scene)) {
        const auto found = gas_oracles().find(name);
        return found == gas_oracles().end() ? std::nullopt : found->second(*gas);
    }
    const auto* grains = std::get_if<Scene>(&scene);
    const auto found = oracles().find(name);
    if (grains == nullptr || found == oracles().end()) return std::nullopt;
    try {
        const double value = found->second(*grains);
        return std::isfinite(value) ? std::optional(value) : std::nullopt;
    } catch (const std::domain_error&) {
        return std::nullopt;
    }
}

std::vector<std::string> oracle_names() {
    std::vector<std::string> names{"analytic:zero"};
    for (const auto& [name, oracle] : oracles())
        names.push_back(name);
    for (const auto& [name, oracle] : signal_oracles())
        names.push_back(name);
    for (const auto& [name, oracle] : gas_oracles())
        names.push_back(name);
    return names;
}

}  // namespace crossgrain::oracles
