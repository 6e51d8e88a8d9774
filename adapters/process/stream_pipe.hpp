// The reading end of a named pipe to which a foreign program writes its trajectory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

namespace crossgrain::adapters::process {

/// We hold a writing end ourselves. So there is no end of file and no hang-up: waiting neither
/// spins after the program has closed the pipe nor blocks when it never opens it, and the end of
/// the stream is the end of the program with nothing left to read.
class StreamPipe {
  public:
    /// Creates the pipe and opens it, so that a program that opens it later does not wait.
    /// Throws std::system_error.
    explicit StreamPipe(const std::filesystem::path& path);
    ~StreamPipe();
    StreamPipe(const StreamPipe&) = delete;
    StreamPipe& operator=(const StreamPipe&) = delete;

    /// Waits until there is something to read, at most `milliseconds`.
    void wait(int milliseconds) const;
    /// What is there, up to a buffer full; empty when there is nothing now. The view is valid until
    /// the next call.
    [[nodiscard]] std::string_view read();

  private:
    int reading_ = -1;
    int writing_ = -1;
    std::vector<char> buffer_;
};

}  // namespace crossgrain::adapters::process
