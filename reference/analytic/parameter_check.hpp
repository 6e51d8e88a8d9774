// Range checks of physical parameters, with the offending name and value in the message.
#pragma once

#include <string_view>

namespace crossgrain::analytic {

/// Throws std::domain_error unless `value` is finite and > 0.
void require_positive(std::string_view name, double value);

/// Throws std::domain_error unless `value` is finite and >= 0.
void require_not_negative(std::string_view name, double value);

}  // namespace crossgrain::analytic
