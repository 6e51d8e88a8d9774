// How a collision table is written: configurations as "0 3" or "i i+2 R", probabilities as the
// paper writes them, "(1-p)/2".
#pragma once

#include "cases/scene/lattice_gas.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace crossgrain::scene {

/// Particles of a site in writing. A class of configurations has directions relative to i.
struct SiteText {
    std::vector<int> directions;  ///< 0..5; in a class: offsets from i, -5..5
    int rests = 0;
    bool is_class = false;
};

/// Words separated by spaces: 0..5, R (once per rest particle), or i, i+1, i-1, ... of a class.
/// Throws std::invalid_argument (what is wrong) for anything else and for mixtures of the two.
[[nodiscard]] SiteText parse_site(std::string_view text);

/// The site of a class for one i, or of its mirror image (left and right exchanged, i kept).
/// Throws std::invalid_argument if a direction occurs twice.
[[nodiscard]] SiteState site_of(const SiteText& text, int i, bool mirrored);

/// A number, or an expression linear in p with + - * / and parentheses.
/// Throws std::invalid_argument for anything else.
[[nodiscard]] RuleProbability parse_probability(std::string_view text);

[[nodiscard]] int mass(const SiteState& site) noexcept;
/// {across to the right, downward}, in units of {sqrt(3)/2, 1/2} site per step.
[[nodiscard]] std::array<int, 2> momentum(const SiteState& site) noexcept;
/// The canonical writing, e.g. "0 3 R".
[[nodiscard]] std::string to_string(const SiteState& site);

}  // namespace crossgrain::scene
