#include "reference/analytic/parameter_check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace crossgrain::analytic {

void require_positive(std::string_view name, double value) {
    if (std::isfinite(value) && value > 0) return;
    throw std::domain_error(fmt::format("{} must be finite and > 0, got {}", name, value));
}

void require_not_negative(std::string_view name, double value) {
    if (std::isfinite(value) && value >= 0) return;
    throw std::domain_error(fmt::format("{} must be finite and >= 0, got {}", name, value));
}

}  // namespace crossgrain::analytic
