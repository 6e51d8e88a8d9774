// Where the time of a step of the bit-sliced engine goes.
#pragma once

#include "native/lga/model.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace crossgrain::lga {

/// Parts of a step, in their order.
enum class Phase {
    reflection,        ///< at the walls
    collision,         ///< and the gravity of the diagonals
    relocation,        ///< of rests beyond one per site
    vertical_gravity,  ///< R -> 0 and 3 -> R
    propagation,
};
inline constexpr std::size_t phases = 5;

/// CPU time per site (of the L x W) and word, in nanoseconds, and random words per site.
struct StepProfile {
    std::array<double, phases> phase_ns{};
    double measurement_ns = 0;  ///< one measurement of all counts, spread over the sites
    double words_per_site = 0;  ///< of random bits, relocation not counted
    double random_word_ns = 0;  ///< making one, in a loop of its own
    [[nodiscard]] double step_ns() const noexcept {
        double sum = 0;
        for (const double ns : phase_ns)
            sum += ns;
        return sum;
    }
};

/// Profiles one word of replicas of `model` over `steps` steps after `warm_up`; the fastest of
/// `repeats` stretches counts, for each part. Measurement is of bins of `bin` sites.
/// Throws std::invalid_argument for a width that the processor does not have, and as
/// make_sliced_ensemble does.
[[nodiscard]] StepProfile profile(const Model& model, int word_bits, std::int64_t warm_up,
                                  std::int64_t steps, int repeats, int bin);

/// How often `words` words of decisions with this probability say yes.
[[nodiscard]] double frequency(double probability, int word_bits, std::int64_t words);

}  // namespace crossgrain::lga
