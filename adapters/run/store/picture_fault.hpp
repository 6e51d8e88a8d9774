// Whether the parts of a picture fit together.
#pragma once

#include "cases/measure/results.hpp"

#include <optional>
#include <string>

namespace crossgrain::store {

/// What is wrong, in words that follow the picture's name ("has 3 pixels for 2 x 2"), or nothing:
/// width x height pixels, at least one, each an index into a palette of at most 256 colours.
[[nodiscard]] std::optional<std::string> picture_fault(const measure::Picture& picture);

}  // namespace crossgrain::store
