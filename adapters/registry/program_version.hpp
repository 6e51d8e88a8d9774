// What this program calls itself, which is also the version of the native codes.
#pragma once

#include <string>

namespace crossgrain::adapters {

/// e.g. "0.1.0 (source 1a2b3c4d)": the digest covers every source that decides a number.
[[nodiscard]] std::string program_version();

}  // namespace crossgrain::adapters
