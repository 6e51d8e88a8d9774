#include "native/base/printable.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <optional>

namespace crossgrain {
namespace {

struct Character {
    char32_t code = 0;
    std::size_t bytes = 0;
};

/// The character that `text` begins with, or nothing if its first byte begins none (RFC 3629: no
/// surrogates, no overlong forms, at most U+10FFFF).
std::optional<Character> first_character(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned lead = byte(0);
    if (lead < 0x80) return Character{lead, 1};
    const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) return std::nullopt;
    char32_t code = lead & (0x7FU >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xC0U) != 0x80) return std::nullopt;
        code = (code << 6U) | (byte(i) & 0x3FU);
    }
    constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    if (code < least[bytes] || surrogate || code > 0x10FFFF) return std::nullopt;
    return Character{code, bytes};
}

bool is_shown_as_it_is(char32_t c) {
    const auto within = [c](char32_t first, char32_t last) { return c >= first && c <= last; };
    return !(c < 0x20 || within(0x7F, 0x9F) ||                    // C0, DEL, C1
             within(0x200B, 0x200F) || within(0x2028, 0x202E) ||  // invisible, direction
             within(0x2060, 0x206F) || c == 0xFEFF || within(0xFFF9, 0xFFFB) ||
             within(0xFDD0, 0xFDEF) || (c & 0xFFFEU) == 0xFFFE);  // noncharacters
}

std::string escaped(char32_t c) {
    if (c == '\n') return "\\n";
    if (c == '\t') return "\\t";
    if (c == '\r') return "\\r";
    if (c < 0x100) return fmt::format("\\x{:02x}", static_cast<unsigned>(c));
    return fmt::format("\\u{{{:x}}}", static_cast<std::uint32_t>(c));
}

/// Appends the first character of `text` as it is shown, and removes it from `text`.
void take_one(std::string_view& text, std::string& shown, bool keep_lines) {
    const auto character = first_character(text);
    const bool kept = character && (is_shown_as_it_is(character->code) ||
                                    (keep_lines && (text[0] == '\n' || text[0] == '\t')));
    if (kept) {
        shown += text.substr(0, character->bytes);
    } else {
        shown += escaped(character ? character->code : static_cast<unsigned char>(text[0]));
    }
    text.remove_prefix(character ? character->bytes : 1);
}

}  // namespace

std::string printable(std::string_view text, std::size_t longest) {
    std::string shown;
    while (!text.empty() && shown.size() < longest)
        take_one(text, shown, false);
    if (!text.empty()) shown += fmt::format("... ({} bytes more)", text.size());
    return shown;
}

std::string printable_lines(std::string_view text, std::size_t longest) {
    std::string shown;
    if (text.size() > longest) {
        shown = fmt::format("({} bytes before)...", text.size() - longest);
        text.remove_prefix(text.size() - longest);
    }
    while (!text.empty())
        take_one(text, shown, true);
    return shown;
}

bool is_printable(std::string_view text) {
    while (!text.empty()) {
        const auto character = first_character(text);
        if (!character || !is_shown_as_it_is(character->code)) return false;
        text.remove_prefix(character->bytes);
    }
    return true;
}

}  // namespace crossgrain
