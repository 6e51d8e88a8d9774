// Names of files and directories that are made from names in case files.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace crossgrain {

/// "case-code-variant" from its parts: empty ones left out, anything but letters, digits and
/// "=._+-" becomes "_", at most `longest` bytes; never empty, hidden, "." or "..". Different parts
/// may give the same stem: a key or a number behind it must tell them apart.
[[nodiscard]] std::string file_stem(const std::vector<std::string>& parts,
                                    std::size_t longest = 160);

}  // namespace crossgrain
