#include "native/hopper/parameters.hpp"

#include "native/base/errors.hpp"
#include "native/hopper/energy.hpp"
#include "native/hopper/geometry.hpp"
#include "native/hopper/neighbourhood.hpp"

#include <fmt/format.h>

#include <string>

namespace crossgrain::hopper {
namespace {

constexpr double largest_hopper = 1e8;  // sites

struct Refusal {
    const char* key;
    const char* problem;
    std::string got, expected, hint;
};

[[noreturn]] void refuse(Refusal refusal) {
    throw CaseError({.key = refusal.key,
                     .problem = refusal.problem,
                     .got = std::move(refusal.got),
                     .expected = std::move(refusal.expected),
                     .hint = std::move(refusal.hint)});
}

void check_hopper(const Parameters& p) {
    if (p.outlet < 2) {
        refuse({.key = "outlet",
                .problem = "is too small",
                .got = fmt::format("{}", p.outlet),
                .expected = "at least 2 sites",
                .hint = "with one site the level above it can have none"});
    }
    if (p.levels < 1) {
        refuse({.key = "levels",
                .problem = "is too small",
                .got = fmt::format("{}", p.levels),
                .expected = "at least 1",
                .hint = "give the number of half-levels of the filling"});
    }
    if (!(p.angle > 0 && p.angle < 180)) {
        refuse({.key = "angle",
                .problem = "is out of range",
                .got = fmt::format("{}", p.angle),
                .expected = "degrees above 0 and below 180",
                .hint = "give the full opening angle theta"});
    }
    const double sites = approximate_sites(p.outlet, p.levels, p.angle);
    if (!(sites <= largest_hopper)) {
        refuse({.key = "levels",
                .problem = "makes too large a hopper",
                .got = fmt::format("about {:.2g} sites", sites),
                .expected = fmt::format("at most {:.0e}", largest_hopper),
                .hint = "take fewer levels or a smaller angle"});
    }
    if (p.flipped < 0) {
        refuse({.key = "flipped",
                .problem = "is negative",
                .got = fmt::format("{}", p.flipped),
                .expected = "0 or more nodes",
                .hint = "0 changes nothing"});
    }
}

bool any_energy(const Energies& c) {
    return c.c_d > 0 || c.c_o > 0 || c.c_i > 0 || c.c_w > 0;
}

/// Whether the energy decides between candidates in some neighbourhood.
bool energy_matters(const Energies& c) {
    for (std::uint32_t index = 0; index < neighbourhoods; ++index) {
        const Cell iloc = neighbourhood(index);
        if (best_candidates(iloc, c) != all_candidates(iloc, c)) return true;
    }
    return false;
}

}  // namespace

void check(const Parameters& parameters) {
    check_hopper(parameters);
    const Energies energies = integer_energies(parameters.rules);
    if (any_energy(energies) && !energy_matters(energies)) {
        refuse({.key = "tie_tolerance",
                .problem = "makes all candidates equal",
                .got = fmt::format("{}", parameters.rules.tie_tolerance),
                .expected = "less than the largest difference of two energies",
                .hint = "take a smaller tolerance, or set all coefficients to 0"});
    }
}

}  // namespace crossgrain::hopper
