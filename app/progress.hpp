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
    /// `total_work` in particle-steps of all runs that will be computed.
    Progress(bool quiet, std::size_t runs, double total_work);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// A run has reached `fraction` of its `work`. Thread-safe, cheap.
    void advanced(const std::string& run, double work, double fraction);
    /// A run has ended, with one line about how.
    void finished(const std::string& run, double work, const std::string& how);

  private:
    void redraw();
    void clear_line() const;
    [[nodiscard]] double work_done() const;

    using Clock = std::chrono::steady_clock;
    bool quiet_, terminal_;
    std::size_t runs_, ended_ = 0;
    double total_work_, ended_work_ = 0;
    std::map<std::string, double> running_work_;
    Clock::time_point start_, drawn_;
    std::mutex mutex_;
};

}  // namespace crossgrain::app
