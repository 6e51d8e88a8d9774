// Progress of many runs: one rewritten line with an ETA on a terminal, one plain line per finished
// run otherwise. All on stderr; stdout belongs to the results.
#pragma once

#include <chrono>
#include <map>
#include <mutex>
#include <string>

namespace crossgrain::app {

class Progress {
  public:
    /// `total_seconds`: CPU seconds expected of all runs that will be computed, by `workers` side
    /// by side. Says so before they start.
    Progress(bool quiet, std::size_t runs, double total_seconds, unsigned workers);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// A run has reached `fraction` of its expected `seconds`. Thread-safe, cheap.
    void advanced(const std::string& run, double seconds, double fraction);
    /// A run has ended, with one line about how.
    void finished(const std::string& run, double seconds, const std::string& how);

  private:
    void redraw();
    void clear_line() const;
    [[nodiscard]] double fraction_done() const;
    /// From the time it took so far; "?" before anything is known.
    [[nodiscard]] std::string time_left() const;

    using Clock = std::chrono::steady_clock;
    bool quiet_, terminal_;
    std::size_t runs_, ended_ = 0;
    double total_, ended_seconds_ = 0;
    std::map<std::string, double> running_;
    Clock::time_point start_, drawn_;
    std::mutex mutex_;
};

}  // namespace crossgrain::app
