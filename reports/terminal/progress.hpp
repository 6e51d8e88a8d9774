// Progress of many runs: one rewritten line with an ETA on a terminal, one plain line per finished
// run otherwise. All on stderr; stdout belongs to the results.
#pragma once

#include "adapters/run/monitor.hpp"

namespace crossgrain::terminal {

/// On stderr; `quiet`: notes only.
class TerminalMonitor final : public run::Monitor {
  public:
    explicit TerminalMonitor(bool quiet) : quiet_(quiet) {}

    void note(const std::string& line) override;
    void remark(const std::string& line) override;
    [[nodiscard]] std::unique_ptr<run::Progress> begin(std::size_t runs, double total_seconds,
                                                       unsigned workers) override;

  private:
    bool quiet_;
};

}  // namespace crossgrain::terminal
