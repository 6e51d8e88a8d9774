// Contenders of a bench take turns, so that a busy machine does not decide; the fastest of several
// turns counts, and the median is told. What is compared is CPU seconds per particle-step, all
// processes and threads together.
#pragma once

#include "adapters/code.hpp"
#include "tests/bench/bench.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace crossgrain::bench {

/// What one turn of a contender has given.
struct Turn {
    adapters::RunCost cost;   ///< of `steps` and the start
    adapters::RunCost start;  ///< of the start and what goes with it; nothing for native kernels
    std::int64_t steps = 0;
    std::map<std::string, std::string> details;
};

struct Contender {
    std::string name;
    std::function<Turn(std::int64_t steps)> run;
    double share = 1;  ///< of the steps of the fastest contender that it is given
    int every = 1;     ///< takes part in every so many turns
    std::vector<Turn> turns = {};
};

/// All contenders take turns on the same state of so many grains.
class Round {
  public:
    Round(const BenchOptions& options, std::size_t grains, std::int64_t steps, int turns)
        : options_(options), grains_(grains), steps_(steps), turns_(turns) {}

    void add(Contender contender) { contenders_.push_back(std::move(contender)); }

    /// Adds a row per contender; `frequency` is the processor's (1/s).
    void run(double frequency, BenchReport& report);

  private:
    const BenchOptions& options_;
    std::size_t grains_;
    std::int64_t steps_;
    int turns_;
    std::vector<Contender> contenders_;
};

/// Cycles per second of this thread as it runs.
[[nodiscard]] double clock_frequency();

/// Null if there is no such row.
[[nodiscard]] const BenchRow* find(const BenchReport& report, const std::string& name,
                                   std::size_t grains);

/// A target: the ratio of two rows is at least so much; nothing where one is missing.
void add_target(BenchReport& report, const std::string& what, const BenchRow* row,
                const BenchRow* other, double at_least, double factor = 1);

/// Ratios of every row to those of the named contenders of the same size.
void tell_ratios(BenchReport& report, const std::vector<std::string>& others);

}  // namespace crossgrain::bench
