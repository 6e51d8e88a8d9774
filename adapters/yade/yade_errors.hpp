// YADE's own words about what went wrong, wherever they come from: the script, Python, YADE's log
// or the C++ run-time. Its exit status alone says little: some errors leave it at 0.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace crossgrain::adapters::yade {

/// The text without the escape sequences that colour it on a terminal.
[[nodiscard]] std::string without_colours(std::string_view text);

/// The most telling error message in YADE's output, in one line; nothing if there is none.
[[nodiscard]] std::optional<std::string> first_error(std::string_view output);

}  // namespace crossgrain::adapters::yade
