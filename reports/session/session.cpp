#include "reports/session/session.hpp"

#include "adapters/registry/codes.hpp"
#include "adapters/registry/program_version.hpp"
#include "adapters/run/case_names.hpp"
#include "adapters/run/model_runs.hpp"
#include "adapters/run/plan.hpp"
#include "adapters/run/runner.hpp"
#include "native/base/errors.hpp"
#include "native/base/machine.hpp"
#include "native/base/share_directory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace crossgrain::session {
namespace {

store::VerdictRow row_of(const compare::Verdict& v) {
    return {.code = v.code,
            .observable = compare::observable_text(v),
            .kind = compare::to_string(v.kind),
            .against = compare::to_string(v.against),
            .setting = compare::setting_text(v),
            .difference = v.difference,
            .uncertainty = v.uncertainty,
            .limit = v.limit,
            .outcome = compare::to_string(v.outcome),
            .expected = v.expected,
            .reason = v.reason};
}

void record(const SessionReport& report, const run::Settings& settings, store::Store& store) {
    const Machine machine = this_machine();
    const auto entry = store.begin_entry(
        {.command = settings.command,
         .version = adapters::program_version(),
         .machine = fmt::format("{}, {} cores, {}", machine.cpu, machine.cores, machine.os)});
    for (const auto& item : report.cases) {
        std::vector<store::VerdictRow> rows;
        for (const auto& verdict : item.evaluation.verdicts)
            rows.push_back(row_of(verdict));
        store.add_verdicts(entry, item.the_case->name, rows);
    }
}

void warn(const scene::AnyScene& scene, const run::Settings& settings) {
    for (const auto& line : scene::warnings_of(scene))
        settings.monitor->remark("warning: " + line);
}

bool has_suite(const std::string& directory, const std::string& name, const std::string& suite) {
    const auto whole = catalog::find_case(directory, name, catalog::Suite::full);
    return std::ranges::find(whole.suites, suite) != whole.suites.end();
}

/// False if this very file was taken already. Throws if another one has the same name: everything
/// that is said of a case is said of its name.
bool is_new(const catalog::Case& found,
            const std::vector<std::shared_ptr<const catalog::Case>>& taken) {
    namespace fs = std::filesystem;
    std::error_code error;
    for (const auto& other : taken) {
        if (fs::equivalent(other->file, found.file, error)) return false;
        if (other->name != found.name) continue;
        throw CaseError({.file = found.file,
                         .key = "name",
                         .problem = "is the name of another case of this call",
                         .got = fmt::format("'{}', also in {}", found.name, other->file),
                         .expected = "a name of its own for each case"});
    }
    return true;
}

/// Says so when a program has changed although its version has not.
void warn_of_changed_programs(const std::vector<run::PlannedRun>& runs, const store::Store& store,
                              const run::Settings& settings) {
    constexpr std::size_t shown = 12;
    std::set<std::string> told;
    for (const auto& run : runs) {
        const auto& record = run.record;
        if (record.digest.empty() || !told.insert(record.code).second) continue;
        const auto before = store.last_digest(record.code, record.version);
        if (!before || *before == record.digest) continue;
        settings.monitor->remark(fmt::format(
            "warning: {} states the version {}, but is not the program that ran before under it "
            "(digest {}, was {}): runs of the one do not stand for the other",
            record.program, record.version, record.digest.substr(0, shown),
            before->substr(0, shown)));
    }
}

}  // namespace

store::Store open_store(const run::Settings& settings, store::Access access) {
    return store::Store(settings.results, access,
                        [monitor = settings.monitor](const std::string& line) {
                            monitor->note("warning: " + line);
                        });
}

std::vector<std::shared_ptr<const catalog::Case>> selected_cases(const run::Settings& settings,
                                                                 const std::stop_token& stop) {
    const std::string directory = (share_directory() / "catalog").string();
    const std::string suite = to_string(settings.suite);
    std::vector<std::shared_ptr<const catalog::Case>> cases;
    const auto chosen = adapters::select_codes(settings.codes);
    const auto names = settings.cases.empty() ? catalog::case_names(directory) : settings.cases;
    for (const auto& name : names) {
        if (stop.stop_requested()) throw Interrupted();
        // Not every case is charted.
        const bool optional = settings.cases.empty() && suite != "quick" && suite != "full";
        if (optional && !has_suite(directory, name, suite)) continue;
        auto found = catalog::find_case(directory, name, settings.suite, settings.map_axes, stop);
        const bool wanted =
            !settings.cases.empty() ||
            std::find(found.suites.begin(), found.suites.end(), suite) != found.suites.end();
        const bool runnable = std::any_of(chosen.begin(), chosen.end(), [&](const auto* code) {
            return run::runs_model(*code, found.model);
        });
        // A case that was named is refused when it is planned; one of the suite is left out.
        if (!wanted || (settings.cases.empty() && !runnable)) continue;
        if (!is_new(found, cases)) continue;
        catalog::check_runs(found, settings.replicas);
        run::check_names(found);
        cases.push_back(std::make_shared<const catalog::Case>(std::move(found)));
    }
    return cases;
}

std::vector<std::string> certifiable_cases() {
    const std::string directory = (share_directory() / "catalog").string();
    std::vector<std::string> names;
    for (const auto& name : catalog::case_names(directory)) {
        const auto found = catalog::find_case(directory, name, catalog::Suite::quick);
        const bool quick = std::ranges::find(found.suites, "quick") != found.suites.end();
        if (quick && judge::can_be_certified(found)) names.push_back(name);
    }
    return names;
}

SessionReport run_session(const run::Settings& settings, store::Store& store, std::stop_token stop,
                          bool compute) {
    const auto cases = selected_cases(settings, stop);
    const auto codes = adapters::select_codes(settings.codes);
    const published::PublishedValues literature(share_directory() / "published");
    std::vector<run::PlannedRun> runs;
    std::vector<const catalog::Case*> owners;
    for (const auto& the_case : cases) {
        for (auto& run : run::plan(*the_case, codes, settings, stop)) {
            if (compute && run.replica == 0) warn(*run.scene, settings);
            owners.push_back(the_case.get());
            runs.push_back(std::move(run));
        }
    }
    warn_of_changed_programs(runs, store, settings);
    run::RunSummary summary =
        run::carry_out(std::move(runs), store, settings, std::move(stop), compute);
    std::map<const catalog::Case*, std::vector<store::RunRecord>> by_case;
    for (std::size_t i = 0; i < owners.size(); ++i) {
        by_case[owners[i]].push_back(std::move(summary.records[i]));
    }
    SessionReport report{.cases = {},
                         .computed = summary.computed,
                         .measured_again = summary.measured_again,
                         .from_store = summary.from_store,
                         .interrupted = summary.interrupted,
                         .store_error = summary.store_error};
    for (const auto& the_case : cases) {
        judge::CaseRuns case_runs(*the_case, std::move(by_case[the_case.get()]));
        judge::Evaluation evaluation = judge::evaluate(case_runs, literature);
        report.cases.push_back({the_case, std::move(case_runs), std::move(evaluation)});
    }
    judge::correct_for_many(report.cases);
    try {
        if (compute) record(report, settings, store);
    } catch (const store::StoreError& error) {
        if (report.store_error.empty()) report.store_error = error.what();
    }
    return report;
}

}  // namespace crossgrain::session
