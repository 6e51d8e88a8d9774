#include "cases/scene/friction_file.hpp"

#include <fmt/format.h>

#include <vector>

namespace crossgrain::scene {
namespace {

using toml_input::ChoiceRule;
using toml_input::KeyedTable;
using toml_input::NumberRule;
using toml_input::OneOf;
using toml_input::Range;
using toml_input::TableRule;

const std::vector<std::string> convention_names{"lammps-granular", "lammps-hooke-history",
                                                "liggghts", "yade", "own"};

double spring_stiffness(const KeyedTable& t, double normal_stiffness) {
    if (t.exactly_one("stiffness") == "stiffness") {
        return t.number("stiffness");
    }
    return t.number("stiffness_ratio") * normal_stiffness;
}

void read_force(const KeyedTable& t, double normal_stiffness, Friction& friction) {
    friction.force = t.choice<TangentialForce>("force");
    if (friction.force == TangentialForce::spring) {
        friction.stiffness = spring_stiffness(t, normal_stiffness);
        friction.damping = t.optional_number("damping").value_or(0);
        return;
    }
    for (const char* key : {"stiffness", "stiffness_ratio"}) {
        if (!t.has(key)) continue;
        throw t.error(key, "contradicts", "force = \"dashpot\"", "no stiffness without a spring",
                      "remove it, or use force = \"spring\"");
    }
    friction.damping = t.number("damping");
    if (friction.damping == 0) {
        throw t.error("damping", "is out of range", "0", Range::positive().text,
                      "a dashpot alone needs one");
    }
}

const toml_input::TableKeys& conventions_keys() {
    using enum toml_input::Need;
    static const ChoiceRule lever{all_words<Lever>()};
    static const toml_input::TableKeys keys{
        .name = "friction.conventions",
        .keys = {{"velocity_lever", lever, "arm of a spin in the relative velocity", required},
                 {"torque_lever", lever, "arm of the tangential force in the torque", required},
                 {"rotation", ChoiceRule{all_words<SpringRotation>()},
                  "how the tangential spring turns with the contact", required},
                 {"limit", ChoiceRule{all_words<CoulombLimit>()},
                  "what the Coulomb limit is applied to", required}}};
    return keys;
}

FrictionConventions read_choices(const KeyedTable& t) {
    const FrictionConventions conventions{.velocity_lever = t.choice<Lever>("velocity_lever"),
                                          .torque_lever = t.choice<Lever>("torque_lever"),
                                          .rotation = t.choice<SpringRotation>("rotation"),
                                          .limit = t.choice<CoulombLimit>("limit")};
    t.reject_unknown_keys();
    return conventions;
}

/// A code's conventions by name, all four in a table, or nothing when each code takes its own.
std::optional<FrictionConventions> read_conventions(const KeyedTable& t) {
    if (t.is_table("conventions")) return read_choices(t.table("conventions"));
    return conventions_named(convention_names[t.choice("conventions")]);
}

}  // namespace

const toml_input::TableKeys& friction_keys() {
    using enum toml_input::Need;
    static const toml_input::TableKeys keys{
        .name = "friction",
        .keys = {{"force", ChoiceRule{all_words<TangentialForce>()},
                  "tangential force before the Coulomb limit", required},
                 {"coefficient", NumberRule{Range::not_negative()},
                  "mu: the tangential force is at most mu times the normal one", required},
                 {"stiffness", NumberRule{Range::positive()}, "k_t of the tangential spring"},
                 {"stiffness_ratio", NumberRule{Range::positive()}, "k_t/k_n of that spring"},
                 {"damping", NumberRule{Range::not_negative()},
                  "of the tangential dashpot; default 0 beside a spring"},
                 {"inertia_factor", NumberRule{Range::left_open(0, 1)},
                  "I = inertia_factor m r^2: 0.5 a disc, 0.4 a sphere", required},
                 {"conventions",
                  {ChoiceRule{convention_names}, TableRule{conventions_keys}},
                  "how a contact is followed from step to step",
                  required}},
        .groups = {OneOf{{"stiffness", "stiffness_ratio"}, false}}};
    return keys;
}

Friction read_friction(const KeyedTable& t, double normal_stiffness) {
    Friction friction;
    read_force(t, normal_stiffness, friction);
    friction.coefficient = t.number("coefficient");
    friction.inertia_factor = t.number("inertia_factor");
    friction.conventions = read_conventions(t);
    t.reject_unknown_keys();
    return friction;
}

}  // namespace crossgrain::scene
