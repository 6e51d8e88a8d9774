#include "adapters/yade/yade_errors.hpp"

#include "adapters/program/error_line.hpp"

#include <algorithm>

namespace crossgrain::adapters::yade {

namespace {

/// The line that ends a traceback, "NameError: name 'x' is not defined": the first one after its
/// start that is neither indented nor empty. The start itself if the text ends before.
std::optional<std::string> exception_in(std::string_view text) {
    constexpr std::string_view start = "Traceback (most recent call last)";
    const std::size_t found = text.find(start);
    if (found == std::string_view::npos) return std::nullopt;
    text.remove_prefix(found);
    while (true) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos || end + 1 == text.size()) return std::string(start);
        text.remove_prefix(end + 1);
        if (text.front() == ' ' || text.front() == '\n') continue;
        return std::string(text.substr(0, text.find('\n')));
    }
}

}  // namespace

std::string without_colours(std::string_view text) {
    std::string plain;
    plain.reserve(text.size());
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text.substr(at, 2) == "\x1b[") {
            at = std::min(text.find('m', at), text.size());  // all of YADE's end with m
        } else {
            plain += text[at];
        }
    }
    return plain;
}

std::optional<std::string> first_error(std::string_view output) {
    const std::string text = without_colours(output);
    // The script's own message; YADE's log; what the C++ run-time says of an uncaught exception.
    for (const std::string_view mark : {"ERROR: ", "<FATAL ERROR>", "<ERROR>", "what():"}) {
        if (auto line = line_starting_with(text, mark)) return line;
    }
    return exception_in(text);
}

}  // namespace crossgrain::adapters::yade
