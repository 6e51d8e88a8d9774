// Folders that YADE leaves behind.
#pragma once

#include <filesystem>

namespace crossgrain::adapters::yade {

/// Where YADE makes its temporary folder, whatever TMPDIR says (core/Omega.cpp).
inline constexpr const char* folder_parent = "/tmp";

/// Removes the empty folders yade-?????? of this user in `parent` that are at least ten seconds
/// old. Never throws.
void remove_old_folders(const std::filesystem::path& parent) noexcept;

/// The same in `folder_parent`, for those of runs that were killed before their script could do it
/// (scene.py.in). Not while a YADE of this user runs, whose folder one of them may be.
void sweep_folders() noexcept;

}  // namespace crossgrain::adapters::yade
