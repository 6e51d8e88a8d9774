// What this program calls itself.
#pragma once

#include <string>

namespace crossgrain::adapters {

/// e.g. "0.1.0 (source 1a2b3c4d)": the digest covers every source that decides a number.
[[nodiscard]] std::string program_version();

/// e.g. "0.1.0".
[[nodiscard]] std::string release_version();

}  // namespace crossgrain::adapters
