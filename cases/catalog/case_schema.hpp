// The JSON schema of case files, for editors and other programs that check them.
#pragma once

#include "cases/toml/keys.hpp"

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace crossgrain::catalog {

/// An observable of [[observable]] as far as files name it.
struct ObservableWords {
    std::string name;
    std::vector<toml_input::Key> options;
    std::string text;  ///< what it measures
};

/// Draft 2020-12, made from the declarations that the reader goes by. `codes`: all that may be
/// named; `observables`: by the name of the model. What no schema can say is left to the reader:
/// keys that must fit each other, and what only the layers of a scene together have.
[[nodiscard]] nlohmann::json
case_schema(const std::vector<std::string>& codes,
            const std::map<std::string, std::vector<ObservableWords>>& observables);

}  // namespace crossgrain::catalog
