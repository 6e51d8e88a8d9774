// The commands of the program. Each returns its exit code.
#pragma once

#include "app/settings.hpp"

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

namespace crossgrain::app {

int list_codes(const Settings& settings, std::stop_token stop);
int list_cases(const Settings& settings);
int list_observables(const Settings& settings);
/// The JSON schema of case files.
int print_schema();

/// Computes what the store lacks, then prints measurements, verdicts and costs.
int run_cases(const Settings& settings, std::stop_token stop);
/// The same from the store alone.
int compare_cases(const Settings& settings);
/// Certificate of equivalence between codes.
int certify_cases(const Settings& settings, std::stop_token stop);
/// All cases of a suite, then the report.
int validate(const Settings& settings, std::stop_token stop);

/// Inputs only, one directory per run below `out`. Exactly one case and one code.
int write_inputs(const Settings& settings, const std::filesystem::path& out, std::stop_token stop);

/// A dump made elsewhere, measured as the run `name` of a case.
struct ReadRequest {
    std::filesystem::path dump;
    std::string name;      ///< of the code that made it
    std::string variant;   ///< empty: the first
    std::size_t rung = 1;  ///< which time step of a ladder, from 1
};
int read_dump(const Settings& settings, const ReadRequest& request, std::stop_token stop);

/// Pages from the store. `open` starts the desktop's browser.
int write_report(const Settings& settings, bool open);
/// Speed side by side; all benches if none is named.
int run_benches(const Settings& settings, const std::vector<std::string>& names, bool quick,
                std::stop_token stop);
/// Thresholds and maps of where methods stop working.
int map_stability(const Settings& settings, const std::stop_token& stop);
/// Runs the charted ladders, and writes cost against error as JSON, CSV and a page.
int chart_cases(const Settings& settings, std::stop_token stop);

struct AdviseRequest {
    std::string observable;  ///< its name, or the beginning of several
    double tolerance = 0;    ///< in the observable's unit, > 0
};
/// From the store alone; exit_run_failed says that the chart must be run first, exit_verdict that
/// nothing charted is within the tolerance.
int advise_case(const Settings& settings, const AdviseRequest& request);
/// Error rates of the verdicts: false alarms, and defects planted on purpose.
struct SelftestRequest {
    std::filesystem::path defects;  ///< directory of the catalogue; empty: that of the source tree
    bool quick = false;             ///< a small part of it
};
int selftest(const Settings& settings, const SelftestRequest& request, std::stop_token stop);
/// Drift of every observable and cost over the store.
int show_history(const Settings& settings);
/// The same, of what left its band only.
int show_regressions(const Settings& settings);

}  // namespace crossgrain::app
