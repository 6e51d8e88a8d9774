// Text from outside (files, file names, what programs print) as text that is safe to show: on a
// terminal, in JSON, in XML. Such text passes through here where it enters.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace crossgrain {

/// Longest text from outside that a message quotes, in bytes.
inline constexpr std::size_t longest_quote = 240;

/// `text` on one line of valid UTF-8. Control characters, bytes that are not UTF-8, and characters
/// that change how others are shown (direction marks, noncharacters) are escaped: "\n", "\t",
/// "\x1b", "\u{202e}". What is longer than `longest` bytes is cut: "... (1234 bytes more)".
[[nodiscard]] std::string printable(std::string_view text, std::size_t longest = longest_quote);

/// The same for several lines: line feeds and tabs stay. Cut at the front, because the end of a log
/// says most.
[[nodiscard]] std::string printable_lines(std::string_view text, std::size_t longest);

/// Whether `text` is shown as it is: printable(text) would escape nothing.
[[nodiscard]] bool is_printable(std::string_view text);

}  // namespace crossgrain
