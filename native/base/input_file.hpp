// A file that the user names as input: opened so that neither a device nor a pipe without a writer
// can hold the program for ever.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>

namespace crossgrain {

/// Regular files and pipes only; whoever reads decides how much is too much.
class InputFile {
  public:
    /// `expected`: what the file should be, for error lines, e.g. "a TOML file". Throws CaseError
    /// for what cannot be opened, a directory, a device.
    InputFile(std::string file, std::string expected, std::stop_token stop = {});
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    /// Fills the front of `into` and returns how much of it; 0 at the end of the file. Waits for
    /// the writer of a pipe. Throws CaseError, and Interrupted when asked to stop.
    std::size_t read(std::span<char> into);

  private:
    void wait();

    std::string file_, expected_;
    std::stop_token stop_;
    int descriptor_ = -1;
};

/// What a file that begins like this is, if it is no UTF-8 text: "is compressed (gzip)", "is
/// UTF-16 text", "is binary"; nothing if it may be text. Looks at the first 4096 bytes.
[[nodiscard]] std::optional<std::string> why_not_text(std::string_view beginning);

/// The three bytes that some editors put before UTF-8 text.
inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

}  // namespace crossgrain
