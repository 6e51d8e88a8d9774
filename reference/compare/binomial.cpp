#include "reference/compare/binomial.hpp"

#include <boost/math/distributions/binomial.hpp>
#include <fmt/format.h>

#include <stdexcept>

namespace crossgrain::compare {

ProportionInterval proportion_interval(std::size_t successes, std::size_t trials,
                                       double confidence) {
    if (trials == 0 || successes > trials || !(confidence > 0 && confidence < 1)) {
        throw std::invalid_argument(fmt::format("no interval for {} of {} at confidence {}",
                                                successes, trials, confidence));
    }
    using Binomial = boost::math::binomial_distribution<double>;
    const auto k = static_cast<double>(successes), n = static_cast<double>(trials);
    const double tail = (1 - confidence) / 2;
    return {.low = successes == 0 ? 0.0 : Binomial::find_lower_bound_on_p(n, k, tail),
            .high = successes == trials ? 1.0 : Binomial::find_upper_bound_on_p(n, k, tail)};
}

}  // namespace crossgrain::compare
