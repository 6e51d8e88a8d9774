#include "adapters/program/answer_judge.hpp"

#include "native/base/printable.hpp"

#include <fmt/format.h>

#include <sstream>

namespace crossgrain::adapters {

namespace {

/// The first line with `part` in it, without surrounding blanks; empty if there is none.
std::string line_with(const std::string& text, const std::string& part) {
    constexpr const char* blanks = " \t\r";
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t start = line.find_first_not_of(blanks);
        if (start == std::string::npos || line.find(part) == std::string::npos) continue;
        return line.substr(start, line.find_last_not_of(blanks) + 1 - start);
    }
    return {};
}

std::string first_words(const process::Answer& answer) {
    const std::string words = line_with(answer.err, "");
    return words.empty() ? line_with(answer.out, "") : words;
}

}  // namespace

std::optional<std::string> why_no_answer(const process::Answer& answer) {
    if (answer.ending != process::Ending::exited) return "was " + answer.ended;
    if (const auto words = line_with(answer.err, "error while loading shared libraries");
        !words.empty()) {
        return "does not run: " + words;
    }
    // So do shells and loaders end whose program cannot be started.
    constexpr int cannot_run = 126, not_found = 127;
    if (answer.status != cannot_run && answer.status != not_found) return std::nullopt;
    const std::string words = first_words(answer);
    return "does not run: " + (words.empty() ? answer.ended : words);
}

std::string last_words(const process::Answer& answer) {
    if (answer.status == 0) return {};
    const std::string words = first_words(answer);
    if (words.empty()) return fmt::format(" ({})", answer.ended);
    return fmt::format(" ({}: '{}')", answer.ended, printable(words));
}

}  // namespace crossgrain::adapters
