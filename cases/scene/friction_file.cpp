#include "cases/scene/friction_file.hpp"

#include "cases/scene/exclusive_keys.hpp"

#include <fmt/format.h>

#include <array>
#include <vector>

namespace crossgrain::scene {
namespace {

using toml_input::Range;
using toml_input::TomlTable;

const std::array<std::string, 2> force_words{"spring", "dashpot"};
const std::array<std::string, 2> lever_words{"radius", "contact-point"};
const std::array<std::string, 3> rotation_words{"project", "project-and-rescale", "rotate"};
const std::array<std::string, 2> limit_words{"total", "spring-only"};
const std::vector<std::string> convention_names{"lammps-granular", "lammps-hooke-history",
                                                "liggghts", "yade", "own"};

double spring_stiffness(const TomlTable& t, double normal_stiffness) {
    if (exactly_one(t, {"stiffness", "stiffness_ratio"}) == "stiffness") {
        return t.number("stiffness", Range::positive());
    }
    return t.number("stiffness_ratio", Range::positive()) * normal_stiffness;
}

void read_force(const TomlTable& t, double normal_stiffness, Friction& friction) {
    friction.force = static_cast<TangentialForce>(t.choice("force", force_words));
    if (friction.force == TangentialForce::spring) {
        friction.stiffness = spring_stiffness(t, normal_stiffness);
        friction.damping = t.optional_number("damping", Range::not_negative()).value_or(0);
        return;
    }
    for (const char* key : {"stiffness", "stiffness_ratio"}) {
        if (!t.has(key)) continue;
        throw t.error(key, "contradicts", "force = \"dashpot\"", "no stiffness without a spring",
                      "remove it, or use force = \"spring\"");
    }
    friction.damping = t.number("damping", Range::positive());
}

FrictionConventions read_choices(const TomlTable& t) {
    const FrictionConventions conventions{
        .velocity_lever = static_cast<Lever>(t.choice("velocity_lever", lever_words)),
        .torque_lever = static_cast<Lever>(t.choice("torque_lever", lever_words)),
        .rotation = static_cast<SpringRotation>(t.choice("rotation", rotation_words)),
        .limit = static_cast<CoulombLimit>(t.choice("limit", limit_words))};
    t.reject_unknown_keys();
    return conventions;
}

/// A code's conventions by name, all four in a table, or nothing when each code takes its own.
std::optional<FrictionConventions> read_conventions(const TomlTable& t) {
    if (t.is_table("conventions")) return read_choices(t.table("conventions"));
    return conventions_named(convention_names[t.choice("conventions", convention_names)]);
}

}  // namespace

Friction read_friction(const TomlTable& t, double normal_stiffness) {
    Friction friction;
    read_force(t, normal_stiffness, friction);
    friction.coefficient = t.number("coefficient", Range::not_negative());
    friction.inertia_factor = t.number("inertia_factor", Range::left_open(0, 1));
    friction.conventions = read_conventions(t);
    t.reject_unknown_keys();
    return friction;
}

}  // namespace crossgrain::scene
