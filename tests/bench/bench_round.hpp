// Contenders of a bench take turns, so that a busy machine does not decide; the fastest of several
// turns counts, and the median is told. What is compared is CPU seconds per unit of work, all
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

/// What one turn of a contender has given, or one stretch of it.
struct Turn {
    adapters::RunCost cost;   ///< of `steps` and the start
    adapters::RunCost start;  ///< of the start and what goes with it; nothing for native kernels
    double steps = 0;         ///< or what else the turn counts, e.g. grain moves
    std::map<std::string, std::string> details = {};
};

/// CPU time of this process and wall time of `work`.
[[nodiscard]] adapters::RunCost timed(const std::function<void()>& work);

/// What is done in one step, and of how large a system it is a step.
struct Work {
    std::string unit;       ///< e.g. "particle-steps"
    std::int64_t size = 0;  ///< e.g. grains, sites
    double per_step = 1;    ///< units in one step
};

struct Contender {
    std::string name;
    Work work;
    std::function<std::vector<Turn>(std::int64_t steps)> run;
    double share = 1;  ///< of the steps of the round that it is given
    int every = 1;     ///< takes part in every so many turns
    std::map<std::string, std::string> details = {};
    std::vector<Turn> turns = {};
};

class Round {
  public:
    Round(const BenchOptions& options, std::int64_t steps, int turns)
        : options_(options), steps_(steps), turns_(turns) {}

    void add(Contender contender) { contenders_.push_back(std::move(contender)); }

    /// Adds a row per contender. Throws Interrupted.
    void run(BenchReport& report);

  private:
    const BenchOptions& options_;
    std::int64_t steps_;
    int turns_;
    std::vector<Contender> contenders_;
};

/// What two threads take from each other when both have a core.
struct ThreadScaling {
    double cpu = 0;   ///< twice the CPU time of both works one by one over that at once
    double wall = 0;  ///< the same of wall time: other programs enter
    double rate = 0;  ///< work per second of two free cores
};

/// `work(0)` and `work(1)`, each its own, return how much they did; the fastest of the turns count.
[[nodiscard]] ThreadScaling two_threads(const BenchOptions& options, int turns,
                                        const std::function<double(int)>& work);

/// Cycles per second of this thread as it runs.
[[nodiscard]] double clock_frequency();

/// A row of it, with the ratio to one thread.
[[nodiscard]] BenchRow row_of_threads(const std::string& name, const std::string& unit,
                                      const ThreadScaling& threads);

/// The first row of that name, which must be there.
[[nodiscard]] const BenchRow& row_named(const BenchReport& report, const std::string& name);

/// Null if there is no such row.
[[nodiscard]] const BenchRow* find(const BenchReport& report, const std::string& name,
                                   std::int64_t size);

/// A target: the ratio of two rows is at least so much; nothing where one is missing.
void add_target(BenchReport& report, const std::string& what, const BenchRow* row,
                const BenchRow* other, double at_least, double factor = 1);

/// Ratios of every row to those of the named contenders of the same size.
void tell_ratios(BenchReport& report, const std::vector<std::string>& others);

}  // namespace crossgrain::bench
