// Files in the results directory that others look for: complete, or not there.
#pragma once

#include <filesystem>
#include <string_view>

namespace crossgrain::run {

/// Writes under another name first, in the same directory, and renames. Two that write the same
/// file at the same time must be kept apart by the caller. Throws CaseError if it cannot be
/// written.
void write_whole_file(const std::filesystem::path& file, std::string_view text);

}  // namespace crossgrain::run
