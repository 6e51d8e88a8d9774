// One call over some cases: plan, run (or read from the store), evaluate, record, exit code.
#pragma once

#include "app/evaluate/case_runs.hpp"
#include "app/evaluate/evaluate.hpp"
#include "app/settings.hpp"
#include "reports/store/store.hpp"

#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace crossgrain::app {

/// Exit codes of the program; scripts rely on them.
enum ExitCode : int {
    exit_ok = 0,          ///< every verdict is `agree` or as expected
    exit_verdict = 1,     ///< an unexpected verdict or a regression
    exit_usage = 2,       ///< bad usage or bad input
    exit_run_failed = 3,  ///< a run failed, a code asked for is absent, or output is lost
    exit_interrupted = 130
};

struct CaseReport {
    std::shared_ptr<const catalog::Case> the_case;
    CaseRuns runs;
    Evaluation evaluation;
};

struct SessionReport {
    std::vector<CaseReport> cases;
    std::size_t computed = 0;
    std::size_t from_store = 0;
    bool interrupted = false;
    std::string store_error;
};

/// The store of the results directory; what it has to say goes to stderr. Throws StoreError.
[[nodiscard]] store::Store open_store(const Settings& settings, store::Access access);

/// The cases named in the settings, each file once, or all of the suite. Throws CaseError, also
/// when two of them have the same name; Interrupted.
[[nodiscard]] std::vector<std::shared_ptr<const catalog::Case>>
selected_cases(const Settings& settings, const std::stop_token& stop);

/// With `compute` false only the store is read. Verdicts are recorded in the store.
[[nodiscard]] SessionReport run_session(const Settings& settings, store::Store& store,
                                        std::stop_token stop, bool compute);

[[nodiscard]] int exit_code(const SessionReport& report, const Settings& settings);

}  // namespace crossgrain::app
