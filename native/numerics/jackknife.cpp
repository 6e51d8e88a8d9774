#include "native/numerics/jackknife.hpp"
#include "native/numerics/mean_with_error.hpp"

namespace crossgrain::numerics {

double jackknife_error(std::span<const double> statistics_without_part) {
    // se^2 = (g-1)/g sum (theta - mean)^2 is the squared error of their mean times (g-1)^2.
    const MeanWithError spread = mean_with_error(statistics_without_part);
    return spread.standard_error * static_cast<double>(spread.n - 1);
}

}  // namespace crossgrain::numerics
