#include "native/hopper/energy.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace crossgrain::hopper {
namespace {

std::uint8_t at(const Cell& cell, int node) noexcept {
    return cell[static_cast<std::size_t>(node)];
}

}  // namespace

Energies integer_energies(const Rules& rules) {
    return {.c_d = to_energy(rules.c_d, "c_d"),
            .c_o = to_energy(rules.c_o, "c_o"),
            .c_i = to_energy(rules.c_i, "c_i"),
            .c_w = to_energy(rules.c_w, "c_w"),
            .tie_tolerance = to_energy(rules.tie_tolerance, "tie_tolerance"),
            .inertia = rules.inertia,
            .rotation = rules.rotation};
}

Cell after_move(const Cell& iloc, const Candidate& candidate) noexcept {
    Cell inew = iloc;
    inew[static_cast<std::size_t>(candidate.source)] = 0;
    inew[1] = static_cast<std::uint8_t>(candidate.orientation);
    return inew;
}

Energy density_energy(const Cell& inew, const Energies& c) noexcept {
    Energy energy = 0;
    for (int j = 2; j <= 7; ++j) {
        if (at(inew, j) != at(inew, 1) && at(inew, j) != outside) energy += c.c_d;
    }
    return energy;
}

Energy orientation_energy(const Cell& iloc, const Candidate& candidate,
                          const Energies& c) noexcept {
    return c.c_o * std::abs((candidate.source - 1) - at(iloc, candidate.source));
}

Energy inertia_energy(const Cell& iloc, const Candidate& candidate, const Energies& c) noexcept {
    const int s = at(iloc, candidate.source);
    const int left_behind = 0;  // INEW(I)
    const int o = c.inertia == Inertia::literal ? left_behind : candidate.orientation;
    return c.c_i * std::abs(s - o);
}

Energy wall_energy(const Cell& inew, const Energies& c) noexcept {
    Energy energy = 0;
    if (at(inew, 5) == outside && at(inew, 1) != 3) energy += c.c_w;
    if (at(inew, 7) == outside && at(inew, 1) != 1) energy += c.c_w;
    return energy;
}

Energy total_energy(const Cell& iloc, const Candidate& candidate, const Energies& c) noexcept {
    const Cell inew = after_move(iloc, candidate);
    return density_energy(inew, c) + orientation_energy(iloc, candidate, c) +
           inertia_energy(iloc, candidate, c) + wall_energy(inew, c);
}

std::uint16_t all_candidates(const Cell& iloc, const Energies& c) noexcept {
    std::uint16_t mask = 0;
    for (int number = 0; number < candidate_count; ++number) {
        const auto candidate = candidate_of(number);
        const std::uint8_t s = at(iloc, candidate.source);
        if (!occupied(s) || (!c.rotation && candidate.orientation != s)) continue;
        mask = static_cast<std::uint16_t>(mask | 1U << number);
    }
    return mask;
}

std::uint16_t best_candidates(const Cell& iloc, const Energies& c) noexcept {
    const std::uint16_t all = all_candidates(iloc, c);
    std::array<Energy, candidate_count> energy{};
    Energy lowest = std::numeric_limits<Energy>::max();
    for (int number = 0; number < candidate_count; ++number) {
        if ((all >> number & 1) == 0) continue;
        const auto n = static_cast<std::size_t>(number);
        energy[n] = total_energy(iloc, candidate_of(number), c);
        lowest = std::min(lowest, energy[n]);
    }
    std::uint16_t mask = 0;
    for (int number = 0; number < candidate_count; ++number) {
        if ((all >> number & 1) == 0) continue;
        if (energy[static_cast<std::size_t>(number)] > lowest + c.tie_tolerance) continue;
        mask = static_cast<std::uint16_t>(mask | 1U << number);
    }
    return mask;
}

}  // namespace crossgrain::hopper
