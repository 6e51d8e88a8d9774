// YADE is a short Python script; what computes lies in a directory of libraries and modules.
#pragma once

#include <filesystem>
#include <vector>

namespace crossgrain::adapters::yade {

/// Shared libraries and Python modules below the directory that YADE's script puts on Python's
/// path ("sys.path.insert(1,'/usr/lib/.../yade/py')"), and beside it; none if the script names no
/// such directory, as one that only calls YADE does.
[[nodiscard]] std::vector<std::filesystem::path> module_files(const std::filesystem::path& script);

}  // namespace crossgrain::adapters::yade
