#include "adapters/program/error_line.hpp"

#include <algorithm>

namespace crossgrain::adapters {

std::optional<std::string> line_starting_with(std::string_view text, std::string_view mark) {
    constexpr std::string_view blanks = " \t\r";
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
        if (!line.starts_with(mark)) continue;
        line.remove_suffix(line.size() - 1 - line.find_last_not_of(blanks));
        return std::string(line);
    }
    return std::nullopt;
}

}  // namespace crossgrain::adapters
