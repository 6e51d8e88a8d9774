// What values on the command line may be. CLI11 parses as C does: "-1" becomes the largest unsigned
// number, what is too large saturates, "nan" is a number.
#pragma once

#include "cases/toml/text_rules.hpp"

#include <CLI/CLI.hpp>

#include <cstdint>

namespace crossgrain::app {

/// Whole numbers from `least` to `most`.
[[nodiscard]] CLI::Validator whole_number(std::uint64_t least, std::uint64_t most);

/// Numbers greater than 0, at most `most`.
[[nodiscard]] CLI::Validator positive_number(double most);

/// Text that passes the gate for texts of case files.
[[nodiscard]] CLI::Validator printable_text(toml_input::TextKind kind);

}  // namespace crossgrain::app
