// Digests that name runs and prepared states by their content.
#pragma once

#include <string>

namespace crossgrain::app {

/// SHA-256 of the text, 64 hexadecimal digits.
[[nodiscard]] std::string sha256(const std::string& text);

}  // namespace crossgrain::app
