// Readings P, D, M and std of the collision rules as test data, written out by hand from their
// tables: independent of the files that ship.
#pragma once

#include "native/lga/model.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace crossgrain::tests {

/// The configuration of these directions, rotated by i.
inline lga::SiteState at(int i, std::initializer_list<int> offsets, int rests = 0) {
    unsigned movers = 0;
    for (const int k : offsets)
        movers |= 1U << ((i + k + 6) % 6);
    return {.movers = static_cast<std::uint8_t>(movers), .rests = static_cast<std::uint8_t>(rests)};
}

inline void head_on(std::vector<lga::Rule>& rules, double p, lga::Matching matching) {
    for (int i = 0; i < 3; ++i) {
        const auto before = at(i, {0, 3});
        rules.push_back({before, at(i, {1, 4}), (1 - p) / 2, matching, "head-on"});
        rules.push_back({before, at(i, {-1, 2}), (1 - p) / 2, matching, "head-on"});
        rules.push_back({before, at(i, {}, 2), p, matching, "head-on"});
        rules.push_back({at(i, {0, 3}, 1), at(i, {}, 3), 1, matching, "head-on with R"});
    }
}

inline void triples(std::vector<lga::Rule>& rules, double p) {
    constexpr auto exact = lga::Matching::exact;
    for (int i = 0; i < 2; ++i) {
        rules.push_back({at(i, {0, 2, 4}), at(i, {1, 3, 5}), 1 - p, exact, "triple"});
        rules.push_back({at(i, {0, 2, 4}), at(i, {}, 3), p, exact, "triple"});
        rules.push_back({at(i, {0, 2, 4}, 1), at(i, {}, 4), 1, exact, "triple with R"});
    }
}

inline void merge_at_120_degrees(std::vector<lga::Rule>& rules, double p) {
    for (int i = 0; i < 6; ++i) {
        rules.push_back({at(i, {0, 2}), at(i, {1}, 1), p, lga::Matching::exact, "120 degrees"});
    }
}

/// A small pipe; tests change what they are about.
inline lga::Model reading(const std::string& name, double p) {
    lga::Model m{.length = 20,
                 .width = 7,
                 .periodic = true,
                 .density = 1,
                 .injection = 0,
                 .gravity = 0.5,
                 .roughness = 0.5,
                 .replicas = 64,
                 .seed = 7};
    const bool spectators = name == "M";
    head_on(m.rules, p, spectators ? lga::Matching::spectators : lga::Matching::exact);
    triples(m.rules, p);
    m.gravity_rule.up_to_rest = name != "M";
    m.gravity_rule.on_walls = name == "std";
    if (name == "P" || name == "D") merge_at_120_degrees(m.rules, p);
    if (name == "P") return m;
    m.walls = lga::WallPlace::inside;
    m.relocation = lga::Relocation::random_walk;
    if (!spectators) return m;
    for (int i = 0; i < 6; ++i) {
        m.rules.push_back(
            {at(i, {0, 2}, 1), at(i, {1}, 2), 1, lga::Matching::spectators, "120 degrees with R"});
        m.rules.push_back({at(i, {0}, 1), at(i, {-1, 1}), 0.1, lga::Matching::exact, "splits R"});
    }
    return m;
}

inline const std::array<std::string, 4> readings{"P", "D", "M", "std"};

}  // namespace crossgrain::tests
