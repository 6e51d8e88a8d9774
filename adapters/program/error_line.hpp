// Finding a program's own words about what went wrong.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace crossgrain::adapters {

/// The first line of `text` that starts with `mark` (after blanks), e.g. "ERROR", without
/// surrounding blanks; or nothing.
[[nodiscard]] std::optional<std::string> line_starting_with(std::string_view text,
                                                            std::string_view mark);

}  // namespace crossgrain::adapters
