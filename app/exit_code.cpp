#include "app/exit_code.hpp"

namespace crossgrain::app {

int exit_code(const session::SessionReport& report, const Settings& settings) {
    if (report.interrupted) return exit_interrupted;
    bool failed = !report.store_error.empty();
    bool unexpected = false;
    for (const auto& item : report.cases) {
        for (const auto& run : item.runs.records()) {
            const bool asked_but_absent =
                run.status == store::RunStatus::not_installed && !settings.codes.empty();
            failed = failed || store::has_failed(run.status) || asked_but_absent;
        }
        for (const auto& verdict : item.evaluation.verdicts) {
            unexpected = unexpected || !verdict.expected;
        }
    }
    if (failed) return exit_run_failed;
    return unexpected ? exit_verdict : exit_ok;
}

}  // namespace crossgrain::app
