// Reading back what a program has printed, however much that was.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace crossgrain::adapters::process {

/// The text of a file, at most its last `limit` bytes; empty if it cannot be read.
[[nodiscard]] std::string read_text(const std::filesystem::path& file, std::size_t limit);

/// At most `lines` last lines of a text file; empty if it cannot be read.
[[nodiscard]] std::string tail(const std::filesystem::path& file, std::size_t lines);

}  // namespace crossgrain::adapters::process
