// What watches over a run inside this process: the user's wish to stop, the time limit, the cost.
#pragma once

#include "adapters/code.hpp"
#include "native/base/cpu_time.hpp"
#include "native/base/errors.hpp"

#include <fmt/format.h>

#include <chrono>
#include <string>
#include <utility>

namespace crossgrain::adapters {

/// One run on one thread, from its construction on.
class Supervisor {
  public:
    /// `options` must outlive it.
    Supervisor(std::string code, const RunOptions& options)
        : code_(std::move(code)), options_(options) {}

    /// To be called between blocks of steps. Throws Interrupted when the user asks, AdapterError
    /// when the time is over.
    void check() const {
        if (options_.stop.stop_requested()) throw Interrupted();
        if (wall_seconds() > options_.time_limit) {
            throw failure(fmt::format("stopped at the time limit of {:g} s", options_.time_limit),
                          true);
        }
    }
    [[nodiscard]] RunCost cost() const {
        return {.cpu_s = thread_cpu_seconds() - cpu_start_, .wall_s = wall_seconds()};
    }
    /// What to throw when the run does not deliver.
    [[nodiscard]] AdapterError failure(std::string reason, bool timed_out = false) const {
        return AdapterError({.code = code_,
                             .reason = std::move(reason),
                             .command = {},
                             .exit = {},
                             .log_tail = {},
                             .directory = options_.directory.string(),
                             .timed_out = timed_out});
    }

  private:
    using Clock = std::chrono::steady_clock;
    [[nodiscard]] double wall_seconds() const {
        return std::chrono::duration<double>(Clock::now() - start_).count();
    }

    std::string code_;
    const RunOptions& options_;
    double cpu_start_ = thread_cpu_seconds();
    Clock::time_point start_ = Clock::now();
};

}  // namespace crossgrain::adapters
