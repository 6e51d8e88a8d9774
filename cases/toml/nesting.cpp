#include "cases/toml/nesting.hpp"

#include "native/base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace crossgrain::toml_input {
namespace {

/// Length of the string that `text` begins with, quotes included (TOML 1.0): "...", '...', or
/// either in triple quotes; the first two end with the line at the latest.
std::size_t string_length(std::string_view text) {
    const char quote = text[0];
    const std::string_view triple = text.substr(0, 3);
    const bool multi_line = triple.size() == 3 && triple[1] == quote && triple[2] == quote;
    for (std::size_t i = multi_line ? 3 : 1; i < text.size(); ++i) {
        if (text[i] == '\\' && quote == '"') {
            ++i;
        } else if (!multi_line && (text[i] == quote || text[i] == '\n')) {
            return i + 1;
        } else if (multi_line && text.substr(i).starts_with(triple)) {
            // One or two more quotes belong to the text before the closing three.
            std::size_t end = i + 3;
            while (end < text.size() && end < i + 5 && text[end] == quote)
                ++end;
            return end;
        }
    }
    return text.size();
}

/// Length of what has to be skipped as a whole: a string, a comment, or one character.
std::size_t token_length(std::string_view text) {
    if (text[0] == '"' || text[0] == '\'') return string_length(text);
    if (text[0] == '#') return std::min(text.find('\n'), text.size());
    return 1;
}

}  // namespace

void check_nesting(std::string_view text, const std::string& file) {
    int dots = 0, open = 0, line = 1;
    std::size_t line_start = 0;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (c == '.') ++dots;
        if (c == '[' || c == '{') ++open;
        if (c == ']' || c == '}') open = std::max(0, open - 1);
        if (std::string_view("\n=,[]{}").find(c) != std::string_view::npos) dots = 0;
        if (dots > deepest_nesting || open > deepest_nesting) {
            throw CaseError({.file = file,
                             .line = line,
                             .column = static_cast<int>(at - line_start) + 1,
                             .problem = dots > deepest_nesting ? "nests tables too deeply"
                                                               : "nests brackets too deeply",
                             .expected = fmt::format("at most {} levels", deepest_nesting)});
        }
        const std::size_t end = at + token_length(text.substr(at));
        for (; at < end; ++at) {
            if (text[at] != '\n') continue;
            ++line;
            line_start = at + 1;
            dots = 0;
        }
    }
}

}  // namespace crossgrain::toml_input
