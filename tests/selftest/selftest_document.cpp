// What a selftest prints: JSON for scripts, tables for people.
#include "tests/selftest/selftest.hpp"

#include "reports/documents/text_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace crossgrain::selftest {
namespace {

using nlohmann::json;

json interval_json(std::size_t some, std::size_t all) {
    if (all == 0) return nullptr;
    const auto interval = compare::proportion_interval(some, all);
    return {interval.low, interval.high};
}

std::string share_text(std::size_t some, std::size_t all) {
    if (all == 0) return "none";
    const auto interval = compare::proportion_interval(some, all);
    return fmt::format("{} of {} ({:.2f} %, 95 % interval {:.2f} ... {:.2f} %)", some, all,
                       100.0 * static_cast<double>(some) / static_cast<double>(all),
                       100 * interval.low, 100 * interval.high);
}

}  // namespace

json selftest_document(const SelftestReport& report) {
    const NullResult& null = report.null;
    json defects = json::array();
    for (const auto& d : report.defects) {
        defects.push_back({{"name", d.name},
                           {"kind", d.kind},
                           {"case", d.case_name},
                           {"code", d.code},
                           {"status", d.skipped.empty() ? "planted" : "not_installed"},
                           {"caught", d.caught},
                           {"by", d.by},
                           {"observable", d.observable},
                           {"reason", d.skipped.empty() ? d.reason : d.skipped},
                           {"culprit", d.culprit},
                           {"culprit_right", d.culprit_right},
                           {"cpu_s", d.cpu_s}});
    }
    return {{"null",
             {{"comparisons", null.comparisons},
              {"false_alarms", null.false_alarms},
              {"ci95", interval_json(null.false_alarms, null.comparisons)},
              {"undecided", null.undecided},
              {"intervals", null.with_interval},
              {"interval_misses", null.misses},
              {"interval_misses_ci95", interval_json(null.misses, null.with_interval)},
              {"alarms", null.alarms},
              {"cpu_s", null.cpu_s}}},
            {"defects", std::move(defects)},
            {"planted", report.planted()},
            {"caught", report.caught()},
            {"culprits_right", report.culprits_right()},
            {"cpu_s", report.cpu_s},
            {"passed", report.passed()}};
}

std::string selftest_table(const SelftestReport& report) {
    const NullResult& null = report.null;
    std::string text = fmt::format("false alarms where nothing is wrong: {}\n",
                                   share_text(null.false_alarms, null.comparisons));
    text += fmt::format("95 % intervals that lack the true difference 0: {}\n",
                        share_text(null.misses, null.with_interval));
    for (const auto& alarm : null.alarms)
        text += "  " + alarm + "\n";
    reports::TextTable table({"defect", "kind", "case", "code", "caught by", "culprit", "CPU s"});
    for (const auto& d : report.defects) {
        const std::string culprit = d.culprit.empty() ? "cannot tell" : d.culprit;
        table.add({d.name, d.kind, d.case_name, d.code,
                   !d.skipped.empty() ? "skipped: " + d.skipped : (d.caught ? d.by : "NOT CAUGHT"),
                   !d.caught ? "-" : culprit + (d.culprit_right ? "" : " (WRONG)"),
                   fmt::format("{:.2f}", d.cpu_s)});
    }
    text += table.text(0);
    return text + fmt::format("{} of {} defects caught, {} culprits right; {:.0f} CPU s\n",
                              report.caught(), report.planted(), report.culprits_right(),
                              report.cpu_s);
}

}  // namespace crossgrain::selftest
