// A program under guard, from its start until nobody of it is left. Leaving the scope ends it and
// everybody it brought along, and so does the end of this process, however it comes.
#pragma once

#include "adapters/process/guard/protocol.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace crossgrain::adapters::process {

struct ChildSetup {
    std::filesystem::path program;                   ///< absolute path
    std::vector<std::string> argv;                   ///< with argv[0]
    std::filesystem::path directory;                 ///< absolute path
    std::vector<std::string> environment;            ///< complete, "NAME=value"
    std::filesystem::path stdout_file, stderr_file;  ///< absolute paths, created or emptied
    std::uint64_t largest_file = 0;                  ///< bytes of any file that it writes
};

/// How a program ended, as the kernel reports it.
struct Reaped {
    bool signalled = false;
    int status = 0;    ///< exit status or signal number
    double cpu_s = 0;  ///< user + system, with all its descendants
};

class Child {
  public:
    /// Throws std::system_error, with the step that failed, if it cannot be started. The program
    /// reads /dev/null, has no open files of ours, default signal handlers and an empty signal
    /// mask.
    explicit Child(const ChildSetup& setup);
    ~Child();
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// Whether the program has ended and nobody of it is left. Throws std::system_error if its
    /// guard was killed.
    [[nodiscard]] bool has_ended();
    /// Sends SIGTERM to the program and its group, and wakes those who are suspended.
    void ask_to_end() const noexcept;
    /// Kills who is left and waits until all are gone.
    Reaped reap();

  private:
    void receive(bool wait);
    void request(guard::Request what) const noexcept;
    void dismiss() noexcept;

    int socket_ = -1;
    pid_t guard_ = -1;
    pid_t program_ = -1;
    std::optional<guard::Report> last_;  ///< how it ended
};

}  // namespace crossgrain::adapters::process
