// A folder whose sources decide numbers.
#pragma once

namespace crossgrain::adapters {

struct SourceFolder {
    const char* folder;  ///< from the top, e.g. "native/dem"
    const char* digest;  ///< SHA-256 of its sources
    const char* needs;   ///< folders that it includes, separated by blanks
};

}  // namespace crossgrain::adapters
