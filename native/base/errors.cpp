#include "native/base/errors.hpp"

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

}  // namespace

CaseError::CaseError(CaseErrorDetails details)
    : std::runtime_error(one_line(details)), details_(std::move(details)) {}

AdapterError::AdapterError(AdapterErrorDetails details)
    : std::runtime_error(one_line(details)), details_(std::move(details)) {}

}  // namespace crossgrain
