#include "native/hopper/initial_state.hpp"

#include "native/base/errors.hpp"
#include "native/hopper/numbers.hpp"

#include <fmt/format.h>

#include <array>
#include <unordered_set>

namespace crossgrain::hopper {
namespace {

constexpr std::uint32_t orientations = 3;

void flip(std::vector<std::uint8_t>& state, int flipped, const Numbers& numbers) {
    std::unordered_set<std::uint32_t> done;
    for (std::uint32_t draw = 0; done.size() < static_cast<std::size_t>(flipped); ++draw) {
        const auto words = numbers.block(draw, 0, Purpose::flips);
        const std::uint32_t site = choose(words[0], static_cast<std::uint32_t>(state.size()));
        if (!done.insert(site).second) continue;
        // Orientation s is number s - 1 of the three; one or two further on is another.
        const std::uint32_t turned = state[site] + choose(words[1], orientations - 1);
        state[site] = static_cast<std::uint8_t>(1 + turned % orientations);
    }
}

}  // namespace

std::vector<std::uint8_t> initial_state(const Parameters& parameters, std::size_t sites) {
    if (static_cast<std::size_t>(parameters.flipped) > sites) {
        throw CaseError({.key = "flipped",
                         .problem = "is more than the hopper has sites",
                         .got = fmt::format("{}", parameters.flipped),
                         .expected = fmt::format("at most {}", sites),
                         .hint = "flip fewer nodes"});
    }
    const Numbers numbers(parameters);
    std::vector<std::uint8_t> state(sites);
    std::array<std::uint32_t, 4> words{};
    for (std::size_t site = 0; site < sites; ++site) {
        if (site % 4 == 0) {
            words = numbers.block(static_cast<std::uint32_t>(site / 4), 0, Purpose::initial_state);
        }
        state[site] = static_cast<std::uint8_t>(1 + choose(words[site % 4], orientations));
    }
    flip(state, parameters.flipped, numbers);
    return state;
}

}  // namespace crossgrain::hopper
