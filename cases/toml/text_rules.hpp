// What texts from outside may be before they become names, labels and descriptions: the one gate
// through which all of them pass.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace crossgrain::toml_input {

/// `name`: one line, not empty, at most 120 bytes. `line`: one line of at most 1000 bytes, which
/// may be empty. `prose`: lines, at most 16000 bytes.
enum class TextKind { name, line, prose };

/// Most bytes of such a text.
[[nodiscard]] std::size_t longest_text(TextKind kind);

/// Why a text is not acceptable, in the words of a CaseError.
struct TextFault {
    std::string problem, got, expected;
};

/// All kinds must be printable (native/base/printable.hpp): valid UTF-8 without control characters
/// and without characters that change how others are shown. Nothing if the text is acceptable.
[[nodiscard]] std::optional<TextFault> fault_in(std::string_view text, TextKind kind);

}  // namespace crossgrain::toml_input
