// The one list of codes. To add one, add a line in codes.cpp.
#pragma once

#include "adapters/code.hpp"
#include "native/base/errors.hpp"

#include <memory>
#include <string>
#include <vector>

namespace crossgrain::adapters {

/// All codes, in the order in which reports show them.
[[nodiscard]] const std::vector<std::unique_ptr<Code>>& codes();

/// Throws CaseError, with the nearest name, unless the code exists. `where` says which file and key
/// named it, if any.
void require_code(const std::string& name, CaseErrorDetails where);

/// Those named, or all if none is; throws CaseError with the nearest name.
[[nodiscard]] std::vector<const Code*> select_codes(const std::vector<std::string>& names);

}  // namespace crossgrain::adapters
