// One call over some cases: plan, run (or read from the store), judge, record.
#pragma once

#include "adapters/run/settings.hpp"
#include "adapters/run/store/store.hpp"
#include "reference/judge/case_report.hpp"

#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace crossgrain::session {

struct SessionReport {
    std::vector<judge::CaseReport> cases;
    std::size_t computed = 0;
    std::size_t measured_again = 0;  ///< from kept frames
    std::size_t from_store = 0;
    bool interrupted = false;
    std::string store_error;
};

/// The store of the results directory; what it has to say goes to stderr. Throws StoreError.
[[nodiscard]] store::Store open_store(const run::Settings& settings, store::Access access);

/// The cases named in the settings, each file once, or all of the suite. Throws CaseError, also
/// when two of them have the same name; Interrupted.
[[nodiscard]] std::vector<std::shared_ptr<const catalog::Case>>
selected_cases(const run::Settings& settings, const std::stop_token& stop);

/// Names of the cases of the quick suite that a certificate can be made of.
[[nodiscard]] std::vector<std::string> certifiable_cases();

/// With `compute` false only the store is read. Verdicts are recorded in the store.
[[nodiscard]] SessionReport run_session(const run::Settings& settings, store::Store& store,
                                        std::stop_token stop, bool compute);

}  // namespace crossgrain::session
