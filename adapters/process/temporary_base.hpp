// Where directories are made that are not part of any results.
#pragma once

#include <filesystem>

namespace crossgrain::adapters::process {

/// <directory for temporary files>/crossgrain-<user's number>, which is this user's alone; made if
/// it is not there. Scratch directories below it can be swept. Throws CaseError if TMPDIR cannot be
/// used, or if somebody else made that directory.
[[nodiscard]] std::filesystem::path temporary_base();

}  // namespace crossgrain::adapters::process
