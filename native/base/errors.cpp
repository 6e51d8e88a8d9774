#include "native/base/errors.hpp"

#include "native/base/printable.hpp"

#include <fmt/format.h>

namespace crossgrain {
namespace {

std::string one_line(const CaseErrorDetails& e) {
    std::string text;
    if (!e.file.empty()) {
        text += e.file;
        if (e.line > 0) text += fmt::format(":{}", e.line);
        if (e.line > 0 && e.column > 0) text += fmt::format(":{}", e.column);
        text += ": ";
    }
    if (!e.key.empty()) text += fmt::format("'{}' ", e.key);
    text += e.problem;
    if (!e.got.empty()) text += fmt::format(": got {}", e.got);
    if (!e.expected.empty()) text += fmt::format(", expected {}", e.expected);
    if (!e.hint.empty()) text += fmt::format("; {}", e.hint);
    return text;
}

std::string one_line(const AdapterErrorDetails& e) {
    std::string text = fmt::format("{}: {}", e.code, e.reason);
    if (!e.exit.empty()) text += fmt::format(" ({})", e.exit);
    if (!e.directory.empty()) text += fmt::format("; inputs and logs in {}", e.directory);
    return text;
}

constexpr std::size_t longest_line = 1000, longest_log = 8000;

/// Errors quote files, names and programs: whatever these hold, an error can be shown.
CaseErrorDetails shown(CaseErrorDetails e) {
    for (auto* text : {&e.file, &e.key, &e.problem, &e.got, &e.hint})
        *text = printable(*text, longest_line);
    e.expected = printable(e.expected, std::string::npos);  // may list all that is known
    return e;
}

AdapterErrorDetails shown(AdapterErrorDetails e) {
    for (auto* text : {&e.code, &e.reason, &e.command, &e.exit, &e.directory})
        *text = printable(*text, longest_line);
    e.log_tail = printable_lines(e.log_tail, longest_log);
    return e;
}

}  // namespace

CaseError::CaseError(const CaseErrorDetails& details)
    : std::runtime_error(one_line(shown(details))), details_(shown(details)) {}

AdapterError::AdapterError(const AdapterErrorDetails& details)
    : std::runtime_error(one_line(shown(details))), details_(shown(details)) {}

}  // namespace crossgrain
