#include "cases/scene/initial_state_file.hpp"

#include "cases/scene/limits.hpp"

#include <fmt/format.h>

#include <cmath>

namespace crossgrain::scene {
namespace {

using toml_input::BooleanRule;
using toml_input::ChoiceRule;
using toml_input::IntegerRule;
using toml_input::Key;
using toml_input::KeyedTable;
using toml_input::NumberRule;
using toml_input::NumbersRule;
using toml_input::Range;
using toml_input::TableKeys;
using enum toml_input::Need;

const Key count_key{"count", IntegerRule{1, most_grains}, "grains or pairs", required};
const Key speed_spread_key{"velocity_spread", NumberRule{Range::not_negative()},
                           "standard deviation of each velocity component", required};
const Key lead_key{"lead_steps", NumberRule{Range::not_negative()},
                   "time steps until the first touches"};

/// Area fraction beyond which no arrangement of equal discs is made.
constexpr double densest = 0.9;

std::size_t count_of(const KeyedTable& t, const char* key) {
    return static_cast<std::size_t>(t.integer(key));
}

/// One number, or [first, last].
Span read_span(const KeyedTable& t, const char* key) {
    if (!t.has(key)) return {};
    const auto ends = t.numbers(key);
    return {.first = ends.front(), .last = ends.back()};
}

const TableKeys& pairs_keys() {
    static const NumbersRule span{Range::any(), 2};
    static const TableKeys keys{
        .name = "initial.pairs",
        .keys = {count_key,
                 {"approach_speed", NumberRule{Range::positive()}, "relative, of a pair", required},
                 {"impact_parameter", NumberRule{Range::any()}, "of a pair, default 0"},
                 {"frozen_partner", BooleanRule{}, "whether the second grain is fixed"},
                 lead_key,
                 {"partner_size", NumberRule{Range::positive()},
                  "second diameter over the first, default 1"},
                 {"tangential_speed", span, "one number, or the first and the last pair's"},
                 {"spin", span, "one number, or the first and the last pair's"},
                 {"partner_spin", span, "one number, or the first and the last pair's"}}};
    return keys;
}

Pairs read_pairs(const KeyedTable& t) {
    Pairs pairs{.count = count_of(t, "count"),
                .approach_speed = t.number("approach_speed"),
                .impact_parameter = t.optional_number("impact_parameter").value_or(0)};
    if (t.has("frozen_partner")) pairs.frozen_partner = t.boolean("frozen_partner");
    if (const auto lead = t.optional_number("lead_steps")) {
        pairs.lead_steps = *lead;
    }
    pairs.tangential_speed = read_span(t, "tangential_speed");
    pairs.spin = read_span(t, "spin");
    pairs.partner_spin = read_span(t, "partner_spin");
    pairs.partner_size = t.optional_number("partner_size").value_or(1);
    if (pairs.frozen_partner && pairs.partner_spin.largest() > 0) {
        throw t.error("partner_spin", "contradicts", "'frozen_partner' as well", "one of the two",
                      "remove one");
    }
    return pairs;
}

const TableKeys& bounces_keys() {
    static const TableKeys keys{
        .name = "initial.bounces",
        .keys = {count_key,
                 {"speed", NumberRule{Range::positive()}, "towards the plate", required},
                 {"target", ChoiceRule{all_words<Target>()}, "the plate, default \"bottom\""},
                 lead_key}};
    return keys;
}

Bounces read_bounces(const KeyedTable& t) {
    Bounces bounces{.count = count_of(t, "count"), .speed = t.number("speed")};
    if (t.has("target")) bounces.target = t.choice<Target>("target");
    if (const auto lead = t.optional_number("lead_steps")) {
        bounces.lead_steps = *lead;
    }
    return bounces;
}

const TableKeys& gas_keys() {
    static const TableKeys keys{.name = "initial.gas",
                                .keys = {count_key,
                                         speed_spread_key,
                                         {"spin_spread", NumberRule{Range::not_negative()},
                                          "standard deviation of spins, default 0"}}};
    return keys;
}

Gas read_gas(const KeyedTable& t) {
    return {.count = count_of(t, "count"),
            .velocity_spread = t.number("velocity_spread"),
            .spin_spread = t.optional_number("spin_spread").value_or(0)};
}

const TableKeys& pipe_keys() {
    static const TableKeys keys{
        .name = "initial.pipe",
        .keys = {
            {"width", NumberRule{Range::positive()}, "between the walls, along x", required},
            {"wall_spacing", NumberRule{Range::positive()}, "of the grains of a wall", required},
            {"area_fraction", NumberRule{Range::left_open(0, densest)}, "covered by moving grains",
             required},
            speed_spread_key,
            {"fall_speed", NumberRule{Range::any()}, "downwards, default 0"},
            {"walls", ChoiceRule{{"rough", "smooth"}}, "default \"rough\""}}};
    return keys;
}

Pipe read_pipe(const KeyedTable& t) {
    return {.width = t.number("width"),
            .wall_spacing = t.number("wall_spacing"),
            .area_fraction = t.number("area_fraction"),
            .velocity_spread = t.number("velocity_spread"),
            .fall_speed = t.optional_number("fall_speed").value_or(0),
            .smooth = t.has("walls") && t.choice("walls") == 1};
}

std::vector<Key> hopper_parts() {
    return {{"angle",
             NumberRule{{.low = 0,
                         .high = 180,
                         .high_open = true,
                         .text = "degrees in [0, 180), the whole opening angle"}},
             "theta in degrees, the whole opening", required},
            {"outlet", NumberRule{Range::positive()}, "width of the opening", required},
            {"height", NumberRule{Range::positive()}, "of the filling", required},
            {"settled_fraction", NumberRule{Range::left_open(0, densest)},
             "area fraction that the filling is expected to settle to, default 0.81"},
            {"velocity_spread", NumberRule{Range::not_negative()},
             "standard deviation of each velocity component, default 0"}};
}

const TableKeys& hopper_keys() {
    static const TableKeys keys{.name = "initial.hopper", .keys = hopper_parts()};
    return keys;
}

Hopper read_hopper(const KeyedTable& t) {
    return {.angle = t.number("angle"),
            .outlet = t.number("outlet"),
            .height = t.number("height"),
            .settled_fraction = t.optional_number("settled_fraction").value_or(0.81),
            .velocity_spread = t.optional_number("velocity_spread").value_or(0)};
}

const TableKeys& settled_keys() {
    static const TableKeys keys = [] {
        TableKeys settled{.name = "initial.settled", .keys = hopper_parts()};
        settled.keys.emplace_back("settle_time", NumberRule{Range::positive()},
                                  "for which the native engine lets the filling settle", required);
        return settled;
    }();
    return keys;
}

Settled read_settled(const KeyedTable& t) {
    return {.hopper = read_hopper(t), .settle_time = t.number("settle_time")};
}

const TableKeys& lattice_keys() {
    static const TableKeys keys{
        .name = "initial.lattice",
        .keys = {count_key,
                 {"columns", IntegerRule{1, most_grains}, "grains of a row", required},
                 speed_spread_key,
                 {"lid_gap", NumberRule{Range::positive()},
                  "between the top row and the lid, default 1"}}};
    return keys;
}

Lattice read_lattice(const KeyedTable& t) {
    return {.count = count_of(t, "count"),
            .columns = count_of(t, "columns"),
            .velocity_spread = t.number("velocity_spread"),
            .lid_gap = t.optional_number("lid_gap").value_or(1.0)};
}

const TableKeys& packing_keys() {
    static const TableKeys keys{.name = "initial.packing", .keys = {count_key, speed_spread_key}};
    return keys;
}

Packing read_packing(const KeyedTable& t) {
    return {.count = count_of(t, "count"), .velocity_spread = t.number("velocity_spread")};
}

const TableKeys& explicit_keys() {
    static const NumbersRule any{Range::any()}, positive{Range::positive()};
    static const TableKeys keys{
        .name = "initial.explicit",
        .keys = {
            {"x", any, "of every grain", required},
            {"y", any, "of every grain", required},
            {"vx", any, "velocity of every grain", required},
            {"vy", any, "velocity of every grain", required},
            {"omega", any, "spin of every grain, default 0"},
            {"diameters", positive, "of every grain, with their masses"},
            {"masses", positive, "of every grain, with their diameters"},
            {"frozen", NumbersRule{Range::not_negative()}, "indices of grains that are fixed"}}};
    return keys;
}

Explicit read_explicit(const KeyedTable& t) {
    Explicit given;
    given.state.x = t.numbers("x");
    given.state.y = t.numbers("y");
    given.state.vx = t.numbers("vx");
    given.state.vy = t.numbers("vy");
    const std::size_t n = given.state.x.size();
    const auto check = [&](const char* key, std::size_t size) {
        if (size != n) {
            throw t.error(key, "has the wrong length", fmt::format("{}", size),
                          fmt::format("{} numbers, as 'x' has", n));
        }
    };
    check("y", given.state.y.size());
    check("vx", given.state.vx.size());
    check("vy", given.state.vy.size());
    if (t.has("omega")) {
        given.state.omega = t.numbers("omega");
        check("omega", given.state.omega.size());
    }
    if (t.has("diameters") || t.has("masses")) {
        given.diameters = t.numbers("diameters");
        given.masses = t.numbers("masses");
        check("diameters", given.diameters.size());
        check("masses", given.masses.size());
    }
    if (t.has("frozen")) {
        given.state.frozen.assign(n, false);
        for (const double index : t.numbers("frozen")) {
            if (index >= static_cast<double>(n) ||
                index != static_cast<double>(static_cast<std::size_t>(index))) {
                throw t.error("frozen", "names no grain", fmt::format("{:g}", index),
                              fmt::format("indices from 0 to {}", n - 1));
            }
            given.state.frozen[static_cast<std::size_t>(index)] = true;
        }
    }
    return given;
}

}  // namespace

const TableKeys& initial_keys() {
    static const TableKeys keys = [] {
        const toml_input::Kinds kinds{.key = "kind",
                                      .of = {{"pairs", pairs_keys},
                                             {"bounces", bounces_keys},
                                             {"gas", gas_keys},
                                             {"lattice", lattice_keys},
                                             {"packing", packing_keys},
                                             {"pipe", pipe_keys},
                                             {"hopper", hopper_keys},
                                             {"settled", settled_keys},
                                             {"explicit", explicit_keys}}};
        return TableKeys{
            .name = "initial",
            .keys = {{"kind", ChoiceRule{kinds.words()}, "how grains start", required}},
            .kinds = kinds};
    }();
    return keys;
}

InitialStateRecipe read_initial_state(const KeyedTable& t) {
    const std::size_t kind = t.choice("kind");
    const InitialStateRecipe recipe = [&]() -> InitialStateRecipe {
        switch (kind) {
        case 0:
            return read_pairs(t);
        case 1:
            return read_bounces(t);
        case 2:
            return read_gas(t);
        case 3:
            return read_lattice(t);
        case 4:
            return read_packing(t);
        case 5:
            return read_pipe(t);
        case 6:
            return read_hopper(t);
        case 7:
            return read_settled(t);
        default:
            return read_explicit(t);
        }
    }();
    t.reject_unknown_keys();
    return recipe;
}

}  // namespace crossgrain::scene
