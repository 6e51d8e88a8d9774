#include "cases/toml/text_rules.hpp"

#include "native/base/printable.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace crossgrain::toml_input {
namespace {

bool is_acceptable(std::string_view text, TextKind kind) {
    if (kind != TextKind::prose) return is_printable(text);
    while (!text.empty()) {
        const std::size_t length = std::min(text.find_first_of("\n\t"), text.size());
        if (!is_printable(text.substr(0, length))) return false;
        text.remove_prefix(std::min(length + 1, text.size()));
    }
    return true;
}

}  // namespace

std::size_t longest_text(TextKind kind) {
    switch (kind) {
    case TextKind::name:
        return 120;
    case TextKind::line:
        return 1'000;
    case TextKind::prose:
        break;
    }
    return 16'000;
}

std::optional<TextFault> fault_in(std::string_view text, TextKind kind) {
    constexpr std::size_t quoted = 80;
    const auto quote = [&] { return fmt::format("\"{}\"", printable(text, quoted)); };
    if (kind == TextKind::name && text.empty()) {
        return TextFault{.problem = "is empty", .got = "\"\"", .expected = "a name"};
    }
    if (text.size() > longest_text(kind)) {
        return TextFault{.problem = "is too long",
                         .got = fmt::format("{} bytes, {}", text.size(), quote()),
                         .expected = fmt::format("at most {} bytes", longest_text(kind))};
    }
    if (is_acceptable(text, kind)) return std::nullopt;
    return TextFault{.problem = "has characters that cannot be shown",
                     .got = quote(),
                     .expected = kind == TextKind::prose ? "text without control characters"
                                                         : "one line without control characters"};
}

}  // namespace crossgrain::toml_input
