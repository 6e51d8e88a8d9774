// crossgrain selftest: the error rates of the verdicts.
#include "app/commands/commands.hpp"
#include "app/exit_code.hpp"
#include "native/base/share_directory.hpp"
#include "reports/session/session.hpp"
#include "reports/terminal/output.hpp"
#include "tests/selftest/selftest.hpp"

#include <nlohmann/json.hpp>

namespace crossgrain::app {

int selftest(const Settings& settings, const SelftestRequest& request, std::stop_token stop) {
    auto catalogue = selftest::load_selftest(request.defects.empty() ? share_directory() / "defects"
                                                                     : request.defects);
    if (request.quick) catalogue = selftest::shortened(std::move(catalogue));
    Settings own = settings;
    own.results = settings.results / "selftest";  // planted defects have no place in the history
    const auto report = selftest::run_selftest(catalogue, own, std::move(stop));
    if (report.interrupted) {
        terminal::print_note("interrupted: the same command goes on from there");
        return exit_interrupted;
    }
    if (settings.json) {
        terminal::print_document(selftest::selftest_document(report));
    } else {
        terminal::print_result_text(selftest::selftest_table(report));
    }
    return report.passed() ? exit_ok : exit_verdict;
}

}  // namespace crossgrain::app
