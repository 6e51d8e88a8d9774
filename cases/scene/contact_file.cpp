#include "cases/scene/contact_file.hpp"

#include "cases/scene/exclusive_keys.hpp"
#include "cases/scene/friction_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace crossgrain::scene {
namespace {

using toml_input::Range;
using toml_input::TomlTable;

const std::array<std::string, 2> damping_words{"full-vector", "normal-only"};
const std::array<std::string, 3> clipping_words{"none", "all", "normal-only"};
const std::array<std::string, 2> spin_words{"off", "on"};
const std::array<std::string, 2> scale_words{"absolute", "effective-mass"};

/// k and eta from restitution and contact time of a head-on collision of two grains of mass m:
/// eta = -m ln(e)/t_col, k = m ((pi/t_col)^2 + (eta/m)^2)/2  (Taguchi, below Eq. 1). Per unit of
/// the effective mass m/2 the dashpot is 2 eta/m.
void stiffness_from_collision(const TomlTable& t, double mass, ContactLaw& law) {
    const double e = t.number("restitution", Range::left_open(0, 1));
    const double t_col = t.number("contact_time", Range::positive());
    const double rate = -std::log(e) / t_col;
    const double omega = std::numbers::pi / t_col;
    const double scale = law.damping_scale == DampingScale::absolute ? mass : 2.0;
    // log(1) is -0: an elastic grain has eta = 0, without a sign.
    law.damping = e == 1 ? 0.0 : scale * rate;
    law.stiffness = mass * (omega * omega + rate * rate) / 2;
}

/// Friction acts at the point of contact of discs that rotate; a dashpot along the contact beside
/// it would be a second tangential force.
void check_friction(const TomlTable& t, const ContactLaw& law) {
    if (!law.friction) return;
    if (law.spins == Spins::off) {
        throw t.error("spins", "contradicts", "\"off\" with friction", "spins = \"on\"",
                      "friction turns grains");
    }
    if (law.damping_acts_on == Damping::full_vector) {
        throw t.error("damping", "contradicts", "\"full-vector\" with friction",
                      "damping = \"normal-only\"", "friction has its own tangential 'damping'");
    }
}

}  // namespace

ContactLaw read_contact(const TomlTable& t, double mass) {
    ContactLaw law;
    if (t.has("damping_scale")) {
        law.damping_scale = static_cast<DampingScale>(t.choice("damping_scale", scale_words));
    }
    if (exactly_one(t, {"restitution", "stiffness"}) == "restitution") {
        stiffness_from_collision(t, mass, law);
        if (t.has("damping_coefficient")) {
            throw t.error("damping_coefficient", "contradicts", "'restitution' as well",
                          "one of the two", "remove one");
        }
    } else {
        law.stiffness = t.number("stiffness", Range::positive());
        law.damping = t.number("damping_coefficient", Range::not_negative());
    }
    law.damping_acts_on = static_cast<Damping>(t.choice("damping", damping_words));
    law.clipping = static_cast<Clipping>(t.choice("clipping", clipping_words));
    law.spins = static_cast<Spins>(t.choice("spins", spin_words));
    if (t.has("friction")) law.friction = read_friction(t.table("friction"), law.stiffness);
    check_friction(t, law);
    t.reject_unknown_keys();
    return law;
}

}  // namespace crossgrain::scene
