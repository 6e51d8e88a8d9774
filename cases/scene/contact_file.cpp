#include "cases/scene/contact_file.hpp"

#include "cases/scene/friction_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace crossgrain::scene {
namespace {

using toml_input::ChoiceRule;
using toml_input::KeyedTable;
using toml_input::NumberRule;
using toml_input::OneOf;
using toml_input::Range;
using toml_input::TableRule;

/// k and eta from restitution and contact time of a head-on collision of two grains of mass m:
/// eta = -m ln(e)/t_col, k = m ((pi/t_col)^2 + (eta/m)^2)/2  (Taguchi, below Eq. 1). Per unit of
/// the effective mass m/2 the dashpot is 2 eta/m.
void stiffness_from_collision(const KeyedTable& t, double mass, ContactLaw& law) {
    const double e = t.number("restitution");
    const double t_col = t.number("contact_time");
    const double rate = -std::log(e) / t_col;
    const double omega = std::numbers::pi / t_col;
    const double scale = law.damping_scale == DampingScale::absolute ? mass : 2.0;
    // log(1) is -0: an elastic grain has eta = 0, without a sign.
    law.damping = e == 1 ? 0.0 : scale * rate;
    law.stiffness = mass * (omega * omega + rate * rate) / 2;
}

/// Friction acts at the point of contact of discs that rotate; a dashpot along the contact beside
/// it would be a second tangential force.
void check_friction(const KeyedTable& t, const ContactLaw& law) {
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

const toml_input::TableKeys& contact_keys() {
    using enum toml_input::Need;
    static const toml_input::TableKeys keys{
        .name = "contact",
        .keys = {{"restitution", NumberRule{Range::left_open(0, 1)},
                  "of a head-on collision of two grains, instead of a stiffness"},
                 {"contact_time", NumberRule{Range::positive()}, "of that collision"},
                 {"stiffness", NumberRule{Range::positive()}, "k of the linear spring"},
                 {"damping_coefficient", NumberRule{Range::not_negative()},
                  "eta of the dashpot, beside a stiffness"},
                 {"damping_scale", ChoiceRule{all_words<DampingScale>()},
                  "the dashpot as it is, or per effective mass; default \"absolute\""},
                 {"damping", ChoiceRule{all_words<Damping>()},
                  "what the dashpot damps: the relative velocity, or its normal component",
                  required},
                 {"clipping", ChoiceRule{all_words<Clipping>()},
                  "what is cut where a contact would attract at its end", required},
                 {"spins", ChoiceRule{all_words<Spins>()}, "whether grains rotate", required},
                 {"friction", TableRule{friction_keys}, "tangential force; left out: none"}},
        .groups = {OneOf{{"restitution", "stiffness"}},
                   OneOf{{"restitution", "damping_coefficient"}, false},
                   OneOf{{"contact_time", "stiffness"}, false}}};
    return keys;
}

ContactLaw read_contact(const KeyedTable& t, double mass) {
    ContactLaw law;
    if (t.has("damping_scale")) {
        law.damping_scale = t.choice<DampingScale>("damping_scale");
    }
    if (t.exactly_one("restitution") == "restitution") {
        stiffness_from_collision(t, mass, law);
        if (t.has("damping_coefficient")) {
            throw t.error("damping_coefficient", "contradicts", "'restitution' as well",
                          "one of the two", "remove one");
        }
    } else {
        law.stiffness = t.number("stiffness");
        law.damping = t.number("damping_coefficient");
    }
    law.damping_acts_on = t.choice<Damping>("damping");
    law.clipping = t.choice<Clipping>("clipping");
    law.spins = t.choice<Spins>("spins");
    if (t.has("friction")) law.friction = read_friction(t.table("friction"), law.stiffness);
    check_friction(t, law);
    t.reject_unknown_keys();
    return law;
}

}  // namespace crossgrain::scene
