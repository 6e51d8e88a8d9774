// Who is told how running goes.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace crossgrain::run {

/// Of runs that are computed side by side. Thread-safe.
class Progress {
  public:
    Progress() = default;
    virtual ~Progress() = default;
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// A run has reached `fraction` of its expected `seconds`. Called often.
    virtual void advanced(const std::string& run, double seconds, double fraction) = 0;
    /// A run has ended, with one line about how.
    virtual void finished(const std::string& run, double seconds, const std::string& how) = 0;
};

class Monitor {
  public:
    Monitor() = default;
    virtual ~Monitor() = default;
    Monitor(const Monitor&) = delete;
    Monitor& operator=(const Monitor&) = delete;

    /// A line that the user should see.
    virtual void note(const std::string& line) = 0;
    /// A line about the scenes and programs of this call, for who looks at it.
    virtual void remark(const std::string& line) = 0;
    /// `total_seconds`: CPU seconds expected of all runs that will be computed, by `workers` side
    /// by side.
    [[nodiscard]] virtual std::unique_ptr<Progress> begin(std::size_t runs, double total_seconds,
                                                          unsigned workers) = 0;
};

/// Keeps everything to itself.
[[nodiscard]] Monitor& silent_monitor();

}  // namespace crossgrain::run
