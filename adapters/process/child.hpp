// A child process that leads its own group, from its start until it has been reaped. Leaving the
// scope ends the whole group.
#pragma once

#include <filesystem>
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
};

/// How a process ended, as the kernel reports it.
struct Reaped {
    bool signalled = false;
    int status = 0;    ///< exit status or signal number
    double cpu_s = 0;  ///< user + system, with its reaped children
};

class Child {
  public:
    /// Throws std::system_error if it cannot be started. The child reads /dev/null, has no open
    /// files of ours, default signal handlers and an empty signal mask.
    explicit Child(const ChildSetup& setup);
    ~Child();
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// Whether the leader has ended. It stays unreaped, so that its group's number stays ours.
    [[nodiscard]] bool has_ended() const;
    void signal_group(int signal_number) const noexcept;
    /// Kills what is left of the group, waits for the leader and reaps it. To be called once.
    Reaped reap();

  private:
    pid_t pid_ = -1;
};

}  // namespace crossgrain::adapters::process
