// crossgrain selftest: the error rates of the verdicts.
#include "app/commands/commands.hpp"
#include "app/exit_code.hpp"
#include "app/output.hpp"
#include "native/base/share_directory.hpp"
#include "reports/session/session.hpp"
#include "tests/selftest/selftest.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace crossgrain::app {
namespace {

/// A tenth of the null comparisons, and of each group the first defect of every kind.
selftest::SelftestCatalogue shortened(selftest::SelftestCatalogue catalogue) {
    for (auto& null : catalogue.nulls)
        null.rounds = std::max(1, null.rounds / 10);
    for (auto& group : catalogue.groups) {
        std::map<selftest::DefectKind, int> seen;
        std::erase_if(group.defects, [&](const auto& defect) { return seen[defect.kind]++ > 0; });
    }
    return catalogue;
}

}  // namespace

int selftest(const Settings& settings, const SelftestRequest& request, std::stop_token stop) {
    auto catalogue = selftest::load_selftest(request.defects.empty() ? share_directory() / "defects"
                                                                     : request.defects);
    if (request.quick) catalogue = shortened(std::move(catalogue));
    Settings own = settings;
    own.results = settings.results / "selftest";  // planted defects have no place in the history
    const auto report = selftest::run_selftest(catalogue, own, std::move(stop));
    if (report.interrupted) {
        print_note("interrupted: the same command goes on from there");
        return exit_interrupted;
    }
    if (settings.json) {
        print_document(selftest::selftest_document(report));
    } else {
        print_result_text(selftest::selftest_table(report));
    }
    return report.passed() ? exit_ok : exit_verdict;
}

}  // namespace crossgrain::app
