// Where the files are that travel with the program.
#pragma once

#include <filesystem>

namespace crossgrain {

/// Directory with catalog/, published/ and web/: $CROSSGRAIN_SHARE, or share/crossgrain next to the
/// executable, or ../share/crossgrain. Throws CaseError if there is none.
[[nodiscard]] std::filesystem::path share_directory();

}  // namespace crossgrain
