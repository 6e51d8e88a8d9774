// How far the verdicts of this program can be trusted, measured: false alarms where nothing is
// wrong, and defects planted on purpose that must be found and blamed on the right code. All of it
// goes the way of any run: plan, run, store, evaluate.
#pragma once

#include "adapters/run/settings.hpp"
#include "reference/compare/binomial.hpp"
#include "tests/selftest/selftest_catalogue.hpp"

#include <nlohmann/json_fwd.hpp>

#include <stop_token>
#include <string>
#include <vector>

namespace crossgrain::selftest {

struct DefectResult {
    std::string name, kind, case_name, code;
    std::string skipped;  ///< why it could not be planted here; empty if it was
    bool caught = false;
    std::string by;          ///< kind, observable and codes of the most telling objection
    std::string observable;  ///< of it
    std::string reason;      ///< what it said
    std::string culprit;     ///< as the verdicts name it; empty if they cannot tell
    bool culprit_right = false;
    double cpu_s = 0;  ///< of the runs with the defect
};

/// One verdict of a null comparison is one comparison.
struct NullResult {
    std::size_t comparisons = 0;
    std::size_t undecided = 0;      ///< of these
    std::size_t false_alarms = 0;   ///< of these: `disagree`, or a failed run
    std::size_t with_interval = 0;  ///< of these: have a 95 % interval of a difference from 0
    std::size_t misses = 0;         ///< of those: the interval lacks 0; 5 % should
    double cpu_s = 0;
    std::vector<std::string> alarms;  ///< one line each
};

struct SelftestReport {
    NullResult null;
    std::vector<DefectResult> defects;
    bool interrupted = false;
    double cpu_s = 0;

    [[nodiscard]] std::size_t planted() const;
    [[nodiscard]] std::size_t caught() const;
    [[nodiscard]] std::size_t culprits_right() const;
    /// Every planted defect caught, false alarms at most 2 %, culprits right in 90 % of the caught.
    [[nodiscard]] bool passed() const;
};

/// `settings.results` holds the store of the runs. Throws CaseError for a defect that cannot be
/// planted as it is written, or a case that is not clean without it.
[[nodiscard]] SelftestReport run_selftest(const SelftestCatalogue& catalogue,
                                          const run::Settings& settings, std::stop_token stop);

/// {"null": {comparisons, false_alarms, ci95, ...}, "defects": [{name, caught, by, culprit_right,
/// cpu_s, ...}]}
[[nodiscard]] nlohmann::json selftest_document(const SelftestReport& report);
[[nodiscard]] std::string selftest_table(const SelftestReport& report);

}  // namespace crossgrain::selftest
