// How deep tables and arrays are nested, found without a parser: parsing and destroying a tree
// recurses as deep as the tree is.
#pragma once

#include <string>
#include <string_view>

namespace crossgrain::toml_input {

/// Most dots in one key ("a.b.c" has two), and most brackets and braces inside one another.
inline constexpr int deepest_nesting = 16;

/// Throws CaseError, with line and column, for TOML text that is nested deeper. Text that is not
/// TOML is left to the parser.
void check_nesting(std::string_view text, const std::string& file);

}  // namespace crossgrain::toml_input
