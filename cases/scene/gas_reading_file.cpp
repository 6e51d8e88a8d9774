#include "cases/scene/gas_reading_file.hpp"

#include "cases/scene/collision_notation.hpp"
#include "cases/toml/toml_table.hpp"
#include "native/base/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <stdexcept>

namespace crossgrain::scene {
namespace {

using toml_input::Range;
using toml_input::TomlTable;

constexpr const char* site_syntax =
    "directions 0 to 5, or i, i+1, i-1, ..., and R per rest particle, separated by spaces";

SiteText read_site(const TomlTable& row, const char* key) {
    try {
        return parse_site(row.text(key));
    } catch (const std::invalid_argument& error) {
        throw row.error(key, "is not a configuration", error.what(), site_syntax);
    }
}

RuleProbability read_probability(const TomlTable& row) {
    if (!row.has("probability")) return {.constant = 1};
    constexpr const char* expected = "a number in [0, 1] or an expression linear in p, "
                                     "as \"(1-p)/2\", in [0, 1] for every p in [0, 1]";
    RuleProbability probability;
    if (row.is_text("probability")) {
        try {
            probability = parse_probability(row.text("probability"));
        } catch (const std::invalid_argument& error) {
            throw row.error("probability", "is not an expression", error.what(), expected);
        }
    } else {
        probability.constant = row.number("probability", Range::any());
    }
    for (const double p : {0.0, 1.0}) {
        const double value = probability.at(p);
        if (value >= 0 && value <= 1) continue;
        throw row.error("probability", "is out of range",
                        fmt::format("{:g} for p = {:g}", value, p), expected);
    }
    return probability;
}

std::string shown(const std::array<int, 2>& momentum) {
    return fmt::format("({}, {})", momentum[0], momentum[1]);
}

void check_conservation(const TomlTable& row, const CollisionRow& rule) {
    const auto differ = [&](const std::string& what, const std::string& before,
                            const std::string& after) {
        return row.error("to", fmt::format("does not conserve {}", what),
                         fmt::format("{} in '{}' -> {} in '{}'", before, to_string(rule.before),
                                     after, to_string(rule.after)),
                         fmt::format("the same {} before and after", what));
    };
    if (mass(rule.before) != mass(rule.after)) {
        throw differ("mass", fmt::format("{}", mass(rule.before)),
                     fmt::format("{}", mass(rule.after)));
    }
    if (momentum(rule.before) != momentum(rule.after)) {
        throw differ("momentum", shown(momentum(rule.before)), shown(momentum(rule.after)));
    }
    if (rule.before.rests > 1) {
        throw row.error("from", "has too many particles at rest",
                        fmt::format("'{}'", to_string(rule.before)),
                        "at most one R before a collision: the others are relocated");
    }
    if (rule.before == rule.after) {
        throw row.error("to", "changes nothing", fmt::format("'{}'", to_string(rule.after)),
                        "another configuration", "what is missing from 1 stays as it is");
    }
}

/// The row for every rotation and mirror image, each once.
std::vector<CollisionRow> images(const TomlTable& row, const SiteText& from, const SiteText& to,
                                 const CollisionRow& common) {
    const bool is_class = from.is_class || to.is_class;
    const bool mirror = row.has("mirror") ? row.boolean("mirror") : true;
    std::vector<CollisionRow> result;
    for (int i = 0; i < (is_class ? 6 : 1); ++i) {
        for (int mirrored = 0; mirrored < (is_class && mirror ? 2 : 1); ++mirrored) {
            CollisionRow image = common;
            try {
                image.before = site_of(from, i, mirrored != 0);
                image.after = site_of(to, i, mirrored != 0);
            } catch (const std::invalid_argument& error) {
                throw row.error("from", "holds a direction twice", error.what(),
                                "at most one mover along each direction");
            }
            const auto same = [&](const CollisionRow& other) {
                return other.before == image.before && other.after == image.after;
            };
            if (std::ranges::none_of(result, same)) result.push_back(image);
        }
    }
    return result;
}

std::vector<CollisionRow> read_row(const TomlTable& row) {
    const SiteText from = read_site(row, "from"), to = read_site(row, "to");
    const bool has_numbers =
        (!from.is_class && !from.directions.empty()) || (!to.is_class && !to.directions.empty());
    if ((from.is_class || to.is_class) && has_numbers) {
        throw row.error("to", "contradicts", "i on one side, numbers on the other",
                        "i or numbers on both sides");
    }
    const bool spectators = row.has("spectators") && row.boolean("spectators");
    const CollisionRow common{.before = {},
                              .after = {},
                              .probability = read_probability(row),
                              .matching = spectators ? Matching::spectators : Matching::exact,
                              .line = row.line()};
    std::vector<CollisionRow> rows = images(row, from, to, common);
    row.reject_unknown_keys();
    for (const CollisionRow& image : rows) {
        check_conservation(row, image);
    }
    return rows;
}

/// Of the rows with this row's configuration: no outcome twice, one kind of matching, and a sum of
/// probabilities that leaves nothing below zero.
void check_against(const std::vector<CollisionRow>& rows, const CollisionRow& added,
                   const TomlTable& row) {
    RuleProbability sum = added.probability;
    for (const CollisionRow& other : rows) {
        if (!(other.before == added.before)) continue;
        if (other.after == added.after) {
            throw row.error("to", "is given twice",
                            fmt::format("'{}' -> '{}' in line {} as well", to_string(added.before),
                                        to_string(added.after), other.line),
                            "one row per outcome", "add the probabilities");
        }
        if (other.matching != added.matching) {
            throw row.error("spectators", "contradicts",
                            fmt::format("'{}' in line {}", to_string(added.before), other.line),
                            "the same in all rows of a configuration");
        }
        sum.constant += other.probability.constant;
        sum.p_factor += other.probability.p_factor;
    }
    for (const double p : {0.0, 1.0}) {
        // Thirds do not add up to one exactly.
        if (sum.at(p) <= 1 + 1e-12) continue;
        throw row.error(
            "probability", "adds up to more than 1",
            fmt::format("{:g} for '{}' at p = {:g}", sum.at(p), to_string(added.before), p),
            "a sum of at most 1 over the rows of a configuration, rotations and mirror "
            "images included");
    }
}

std::vector<CollisionRow> read_rows(const TomlTable& t) {
    std::vector<CollisionRow> rows;
    for (const TomlTable& row : t.tables("collision")) {
        for (const CollisionRow& image : read_row(row)) {
            check_against(rows, image, row);
            rows.push_back(image);
        }
    }
    if (rows.empty()) throw t.missing("collision", "the rows of the collision table");
    return rows;
}

GravityRule read_gravity(const TomlTable& t) {
    const GravityRule gravity{.rest_to_down = t.boolean("rest_to_down"),
                              .up_diagonals = t.boolean("up_diagonals"),
                              .up_to_rest = t.boolean("up_to_rest"),
                              .on_walls = t.boolean("on_walls")};
    t.reject_unknown_keys();
    return gravity;
}

}  // namespace

GasReading load_gas_reading(const std::string& file) {
    const toml::table root = toml_input::parse_toml_file(file);
    const TomlTable t(file, "", {&root});
    GasReading reading{.name = printable(std::filesystem::path(file).stem().string()),
                       .text = t.has("text") ? t.prose("text") : "",
                       .rows = read_rows(t),
                       .gravity = read_gravity(t.table("gravity")),
                       .walls = t.choice<WallPlace>("walls"),
                       .relocation = t.choice<Relocation>("relocation"),
                       .file = file};
    t.reject_unknown_keys();
    return reading;
}

}  // namespace crossgrain::scene
