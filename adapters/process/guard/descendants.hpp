// Ending everybody whom a program brought along.
#pragma once

#include <chrono>
#include <optional>

#include <sys/types.h>

namespace crossgrain::adapters::process::guard {

/// The children of this process: the program (`leader`), which leads a group, and everybody below
/// it who lost its own parent, because this process adopts them (PR_SET_CHILD_SUBREAPER).
class Descendants {
  public:
    explicit Descendants(pid_t leader) : leader_(leader) {}

    /// Sends a signal to the leader's group.
    void signal_group(int signal_number) const noexcept;
    /// Reaps everybody who has ended but the leader. Whether the leader has ended; it stays
    /// unreaped, so that nobody else gets the number of its group.
    bool reap_others();
    /// Kills and reaps until nobody is left, the leader included. Who cannot be killed (another
    /// user's program, a process that waits for a disk) is waited for no longer than `patience`.
    void end(std::chrono::milliseconds patience);
    /// How the leader ended, as waitpid tells it; nothing if it has not been reaped.
    [[nodiscard]] std::optional<int> status() const noexcept { return status_; }

  private:
    void kill_all() const;
    bool reap_all();

    pid_t leader_;
    std::optional<int> status_;
};

}  // namespace crossgrain::adapters::process::guard
