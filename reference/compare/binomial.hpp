// Interval of a proportion from counts, exact (Clopper & Pearson, Biometrika 26, 404 (1934)).
#pragma once

#include <cstddef>

namespace crossgrain::compare {

struct ProportionInterval {
    double low = 0, high = 1;
};

/// Both tails at most (1 - confidence)/2: covers the true proportion in at least `confidence` of
/// all samples, whatever it is. Throws std::invalid_argument unless successes <= trials, trials > 0
/// and 0 < confidence < 1.
[[nodiscard]] ProportionInterval proportion_interval(std::size_t successes, std::size_t trials,
                                                     double confidence = 0.95);

}  // namespace crossgrain::compare
