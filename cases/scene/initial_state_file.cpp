#include "cases/scene/initial_state_file.hpp"

#include "cases/scene/limits.hpp"

#include <fmt/format.h>

#include <array>

namespace crossgrain::scene {
namespace {

using toml_input::Range;
using toml_input::TomlTable;

std::size_t count_of(const TomlTable& t, const char* key) {
    return static_cast<std::size_t>(t.integer(key, 1, most_grains));
}

/// One number, or [first, last].
Span read_span(const TomlTable& t, const char* key) {
    if (!t.has(key)) return {};
    const auto ends = t.numbers(key, Range::any());
    if (ends.size() > 2) {
        throw t.error(key, "has the wrong length", fmt::format("{}", ends.size()),
                      "one number, or the first and the last pair's");
    }
    return {.first = ends.front(), .last = ends.back()};
}

Pairs read_pairs(const TomlTable& t) {
    Pairs pairs{.count = count_of(t, "count"),
                .approach_speed = t.number("approach_speed", Range::positive()),
                .impact_parameter =
                    t.optional_number("impact_parameter", Range::any()).value_or(0)};
    if (t.has("frozen_partner")) pairs.frozen_partner = t.boolean("frozen_partner");
    if (const auto lead = t.optional_number("lead_steps", Range::not_negative())) {
        pairs.lead_steps = *lead;
    }
    pairs.tangential_speed = read_span(t, "tangential_speed");
    pairs.spin = read_span(t, "spin");
    pairs.partner_spin = read_span(t, "partner_spin");
    pairs.partner_size = t.optional_number("partner_size", Range::positive()).value_or(1);
    if (pairs.frozen_partner && pairs.partner_spin.largest() > 0) {
        throw t.error("partner_spin", "contradicts", "'frozen_partner' as well", "one of the two",
                      "remove one");
    }
    return pairs;
}

Bounces read_bounces(const TomlTable& t) {
    static const std::array<std::string, 2> targets{"bottom", "lid"};
    Bounces bounces{.count = count_of(t, "count"), .speed = t.number("speed", Range::positive())};
    if (t.has("target")) bounces.target = static_cast<Target>(t.choice("target", targets));
    if (const auto lead = t.optional_number("lead_steps", Range::not_negative())) {
        bounces.lead_steps = *lead;
    }
    return bounces;
}

Gas read_gas(const TomlTable& t) {
    return {.count = count_of(t, "count"),
            .velocity_spread = t.number("velocity_spread", Range::not_negative()),
            .spin_spread = t.optional_number("spin_spread", Range::not_negative()).value_or(0)};
}

Pipe read_pipe(const TomlTable& t) {
    static const std::array<std::string, 2> walls{"rough", "smooth"};
    return {.width = t.number("width", Range::positive()),
            .wall_spacing = t.number("wall_spacing", Range::positive()),
            .area_fraction = t.number("area_fraction", Range::left_open(0, 0.9)),
            .velocity_spread = t.number("velocity_spread", Range::not_negative()),
            .fall_speed = t.optional_number("fall_speed", Range::any()).value_or(0),
            .smooth = t.has("walls") && t.choice("walls", walls) == 1};
}

Hopper read_hopper(const TomlTable& t) {
    const Hopper hopper{
        .angle = t.number("angle", Range::not_negative()),
        .outlet = t.number("outlet", Range::positive()),
        .height = t.number("height", Range::positive()),
        .settled_fraction =
            t.optional_number("settled_fraction", Range::left_open(0, 0.9)).value_or(0.81),
        .velocity_spread = t.optional_number("velocity_spread", Range::not_negative()).value_or(0)};
    if (hopper.angle >= 180) {
        throw t.error("angle", "is out of range", fmt::format("{:g}", hopper.angle),
                      "degrees in [0, 180), the whole opening angle");
    }
    return hopper;
}

Settled read_settled(const TomlTable& t) {
    return {.hopper = read_hopper(t), .settle_time = t.number("settle_time", Range::positive())};
}

Lattice read_lattice(const TomlTable& t) {
    return {.count = count_of(t, "count"),
            .columns = count_of(t, "columns"),
            .velocity_spread = t.number("velocity_spread", Range::not_negative()),
            .lid_gap = t.optional_number("lid_gap", Range::positive()).value_or(1.0)};
}

Packing read_packing(const TomlTable& t) {
    return {.count = count_of(t, "count"),
            .velocity_spread = t.number("velocity_spread", Range::not_negative())};
}

Explicit read_explicit(const TomlTable& t) {
    Explicit given;
    given.state.x = t.numbers("x", Range::any());
    given.state.y = t.numbers("y", Range::any());
    given.state.vx = t.numbers("vx", Range::any());
    given.state.vy = t.numbers("vy", Range::any());
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
        given.state.omega = t.numbers("omega", Range::any());
        check("omega", given.state.omega.size());
    }
    if (t.has("diameters") || t.has("masses")) {
        given.diameters = t.numbers("diameters", Range::positive());
        given.masses = t.numbers("masses", Range::positive());
        check("diameters", given.diameters.size());
        check("masses", given.masses.size());
    }
    if (t.has("frozen")) {
        given.state.frozen.assign(n, false);
        for (const double index : t.numbers("frozen", Range::not_negative())) {
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

InitialStateRecipe read_initial_state(const TomlTable& t) {
    static const std::array<std::string, 9> kinds{
        "pairs", "bounces", "gas", "lattice", "packing", "pipe", "hopper", "settled", "explicit"};
    const std::size_t kind = t.choice("kind", kinds);
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
