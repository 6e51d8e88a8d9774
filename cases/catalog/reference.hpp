// What a case file writes as `against`: "analytic:restitution", "published:gremaud/exponent",
// "converged:P/replicas-512". Read here once; no other code takes the text apart.
#pragma once

#include "native/base/enum_words.hpp"

#include <initializer_list>
#include <string>

namespace crossgrain::toml_input {
class KeyedTable;
}

namespace crossgrain::catalog {

struct Reference {
    enum class Kind {
        closed_form,  ///< of reference/oracles
        published,    ///< a value or trend of the literature, "<file>/<name>"
        converged     ///< a variant of the case, in the first code that has it
    };
    Kind kind = Kind::closed_form;
    std::string name;  ///< what follows the colon; empty: no reference

    friend bool operator==(const Reference&, const Reference&) = default;
};

using crossgrain::to_string;  // of enums, which the next would hide
/// As the file has it, "analytic:restitution"; empty without a name.
[[nodiscard]] std::string to_string(const Reference& reference);

/// Reads the key `against`. Throws CaseError for a text that names none of the kinds.
[[nodiscard]] Reference read_reference(const toml_input::KeyedTable& t,
                                       std::initializer_list<Reference::Kind> kinds);

}  // namespace crossgrain::catalog
