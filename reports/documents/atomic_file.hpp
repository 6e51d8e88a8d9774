// Writes a file so that readers see the old text or the new one, never a part of it.
#pragma once

#include <filesystem>
#include <string_view>

namespace crossgrain::reports {

/// Creates missing parent folders, writes a temporary file beside `path` and renames it.
/// @throws std::system_error naming `path` and what failed.
void write_file_atomically(const std::filesystem::path& path, std::string_view text);

/// Removes temporary files that processes left in `folder` when they were killed.
void remove_unfinished_files(const std::filesystem::path& folder);

}  // namespace crossgrain::reports
