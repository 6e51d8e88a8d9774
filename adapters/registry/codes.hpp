// The one list of codes. To add one, add a line in codes.cpp.
#pragma once

#include "adapters/code.hpp"
#include "native/base/errors.hpp"

#include <string>
#include <vector>

namespace crossgrain::adapters {

/// All codes, in the order in which reports show them.
[[nodiscard]] const std::vector<const Code*>& codes();

/// SHA-256 over the sources that decide the frames of a code. Throws std::invalid_argument for an
/// unknown one.
[[nodiscard]] std::string code_source_key(const std::string& name);

/// For the order of runs and for progress; no result depends on it.
struct TypicalCost {
    double start_s = 1;  ///< CPU seconds to start the program
    double rate = 1e7;   ///< work per CPU second on one current core, in the unit of the model
};
/// As the benches measure it (a factor of two either way); of an unknown code a guess.
[[nodiscard]] TypicalCost typical_cost(const std::string& name);

/// Throws CaseError, with the nearest name, unless the code exists. `where` says which file and key
/// named it, if any.
void require_code(const std::string& name, CaseErrorDetails where);

/// Those named, or all if none is; throws CaseError with the nearest name.
[[nodiscard]] std::vector<const Code*> select_codes(const std::vector<std::string>& names);

}  // namespace crossgrain::adapters
