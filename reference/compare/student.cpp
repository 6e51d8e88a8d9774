#include "reference/compare/student.hpp"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace crossgrain::compare {

double student_quantile(double probability, double degrees_of_freedom) {
    if (!(probability > 0 && probability < 1) || !(degrees_of_freedom > 0)) {
        throw std::domain_error(
            fmt::format("no t quantile for probability {} and {} degrees of freedom", probability,
                        degrees_of_freedom));
    }
    if (std::isinf(degrees_of_freedom)) {
        return boost::math::quantile(boost::math::normal(), probability);
    }
    return boost::math::quantile(boost::math::students_t(degrees_of_freedom), probability);
}

double welch_degrees_of_freedom(double s1, double dof1, double s2, double dof2) {
    const bool valid = s1 >= 0 && s2 >= 0 && dof1 > 0 && dof2 > 0 && std::isfinite(s1 + s2);
    if (!valid) {
        throw std::domain_error(fmt::format(
            "no degrees of freedom for standard errors {} ({}) and {} ({})", s1, dof1, s2, dof2));
    }
    const double largest = std::max(s1, s2);
    if (largest == 0) return std::numeric_limits<double>::infinity();
    // Shares of the larger error, so that the fourth powers of small errors do not underflow.
    const double v1 = s1 / largest * (s1 / largest), v2 = s2 / largest * (s2 / largest);
    const double sum = v1 + v2;
    return sum * sum / (v1 * v1 / dof1 + v2 * v2 / dof2);
}

}  // namespace crossgrain::compare
