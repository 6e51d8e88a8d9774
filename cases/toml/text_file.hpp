// The text of an input file, or one clear line about why it is none.
#pragma once

#include <cstddef>
#include <stop_token>
#include <string>

namespace crossgrain::toml_input {

/// Longest file that is read, in bytes: a hundred times what any case needs.
inline constexpr std::size_t longest_file = std::size_t{16} << 20;

/// Reads a regular file or a pipe. `expected`: what it should be, for error lines. Throws CaseError
/// for what cannot be read, is no text (compressed, UTF-16, binary) or is longer than
/// `longest_file`; Interrupted when asked to stop while it waits.
[[nodiscard]] std::string read_text_file(const std::string& file, const std::string& expected,
                                         std::stop_token stop = {});

}  // namespace crossgrain::toml_input
