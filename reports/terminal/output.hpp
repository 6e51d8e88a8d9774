// What the program prints: results on stdout, whose loss is an error, and notes on stderr, whose
// loss is none. Text that came from outside does not reach a terminal as it is (printable.hpp).
#pragma once

#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json_fwd.hpp>

namespace crossgrain::terminal {

/// Opens what the caller has closed of stdin, stdout and stderr, so that no file of ours is taken
/// for one of them. What is then written to a closed one fails, as it should. To be called first.
void open_standard_streams();

/// Lines of results. Never throws for a failed write: lost_results() tells of it in the end, so
/// that neither a closed pipe nor a full disk keeps a command from finishing its work.
void print_result_text(std::string_view text);

template <class... T>
void print_results(fmt::format_string<T...> format, T&&... values) {
    print_result_text(fmt::format(format, std::forward<T>(values)...));
}

/// Valid JSON whatever texts it holds, indented, as one result.
void print_document(const nlohmann::json& document);

/// Where stdout and stderr are one file, results come before the notes that follow.
void flush_results() noexcept;

/// Flushes, and says why results did not arrive ("No space left on device"); nothing if all did.
[[nodiscard]] std::optional<std::string> lost_results();

/// Bytes on stderr as they are. Thread-safe, never fails; where nobody reads stderr any more
/// (EPIPE), the process gets one SIGPIPE, which stops it like SIGTERM.
void write_to_stderr(std::string_view bytes) noexcept;

void print_note_text(std::string_view text);

/// A note on a line of its own: progress, warnings, errors. Thread-safe, as write_to_stderr().
template <class... T>
void print_note(fmt::format_string<T...> format, T&&... values) {
    print_note_text(fmt::format(format, std::forward<T>(values)...));
}

/// What `write` throws, or nothing. Files are written before anything is printed, so that a closed
/// pipe cannot keep them back; what was computed is printed even when they cannot be written, and
/// what was thrown is thrown again afterwards.
[[nodiscard]] std::exception_ptr failure_of(const std::function<void()>& write);

}  // namespace crossgrain::terminal
