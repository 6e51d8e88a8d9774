// Names in a case that other rooms give a meaning to.
#pragma once

#include "cases/catalog/case.hpp"

namespace crossgrain::run {

/// Checks the names of observables, options and codes, so that a typing error is found before any
/// run. Throws CaseError.
void check_names(const catalog::Case& the_case);

}  // namespace crossgrain::run
