// crossgrain run | compare | certify | validate | report | history.
#include "adapters/process/detached.hpp"
#include "adapters/process/find_program.hpp"
#include "app/commands/commands.hpp"
#include "app/exit_code.hpp"
#include "native/base/share_directory.hpp"
#include "reports/documents/atomic_file.hpp"
#include "reports/documents/csv.hpp"
#include "reports/documents/documents.hpp"
#include "reports/documents/junit.hpp"
#include "reports/documents/summary.hpp"
#include "reports/documents/tables.hpp"
#include "reports/session/session.hpp"
#include "reports/studies/attribution.hpp"
#include "reports/studies/history.hpp"
#include "reports/studies/models/models_table.hpp"
#include "reports/terminal/output.hpp"
#include "reports/web/pages.hpp"
#include "reports/web/report_document.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <exception>
#include <map>
#include <string>

namespace crossgrain::app {
namespace {

/// Codes that are not on this machine, with the reason.
std::map<std::string, std::string> absent_codes(const session::SessionReport& report) {
    std::map<std::string, std::string> absent;
    for (const auto& item : report.cases) {
        for (const auto& run : item.runs.records())
            if (run.status == store::RunStatus::not_installed) absent[run.code] = run.reason;
    }
    return absent;
}

/// What happened besides the results, on stderr; and the exit code.
int close_session(const session::SessionReport& report, const Settings& settings) {
    terminal::flush_results();
    if (!report.store_error.empty()) {
        terminal::print_note("error: {}; the results above are complete but not stored",
                             report.store_error);
    }
    for (const auto& [code, reason] : absent_codes(report))
        terminal::print_note("{} is not installed: {}", code, reason);
    if (report.interrupted) {
        terminal::print_note("interrupted: {} runs are stored; the same command goes on from there",
                             report.computed + report.measured_again + report.from_store);
    }
    if (!settings.quiet) {
        if (report.measured_again > 0)
            terminal::print_note("{} runs measured again from kept frames", report.measured_again);
        terminal::print_note("{} runs computed, {} taken from {}", report.computed,
                             report.from_store, settings.results.string());
    }
    return exit_code(report, settings);
}

void print_cases(const session::SessionReport& report, const Settings& settings) {
    if (settings.json) {
        terminal::print_document(reports::cases_document(report));
        return;
    }
    for (const auto& item : report.cases)
        terminal::print_results("{}\n", reports::case_table(item));
    terminal::print_results("{}\n{}", reports::verdict_table(report),
                            reports::exceptions_list(report));
}

/// Pages (where the build has them), JUnit XML and CSV below <results>/report.
void write_report_files(const session::SessionReport& report, const store::Store& store,
                        const Settings& settings) {
    const auto document =
        reports::report_document(report, studies::history_of(store.history()), settings.command);
    const auto directory = settings.results / "report";
    reports::write_page(reports::Page::report, document, settings);
    reports::write_file_atomically(directory / "junit.xml", reports::junit_xml(document));
    reports::write_file_atomically(directory / "measurements.csv",
                                   reports::measurements_csv(document));
    reports::write_file_atomically(directory / "verdicts.csv", reports::verdicts_csv(document));
}

/// Names of phenomena among those of cases.
struct Compared {
    std::vector<std::string> cases, phenomena;
};
Compared split_phenomena(const std::vector<std::string>& names) {
    const auto known = studies::phenomenon_names(studies::phenomena_directory());
    Compared compared;
    for (const auto& name : names) {
        const bool found = std::ranges::find(known, name) != known.end();
        (found ? compared.phenomena : compared.cases).push_back(name);
    }
    return compared;
}

void open_in_browser(const std::filesystem::path& page) {
    namespace process = adapters::process;
    const auto opener = process::find_program("xdg-open");
    const bool shown =
        opener && process::start_detached(*opener, {std::filesystem::absolute(page).string()});
    if (!shown)
        terminal::print_note("no program is set up to open {} here", page.filename().string());
}

}  // namespace

int run_cases(const Settings& settings, std::stop_token stop) {
    store::Store store = session::open_store(settings, store::Access::write_later);
    const auto report = session::run_session(settings, store, std::move(stop), true);
    print_cases(report, settings);
    return close_session(report, settings);
}

int compare_cases(const Settings& settings) {
    store::Store store = session::open_store(settings, store::Access::read);
    const auto [cases, phenomena] = split_phenomena(settings.cases);
    nlohmann::json tables = nlohmann::json::array();
    std::string text;
    int code = exit_ok;
    for (const auto& phenomenon : phenomena) {
        const studies::ModelsTable table = studies::models_table(phenomenon, settings, store);
        tables.push_back(json_of(table));
        text += text_of(table) + "\n";
    }
    nlohmann::json document = {{"cases", nlohmann::json::array()}};
    if (!cases.empty() || phenomena.empty()) {
        Settings named = settings;
        named.cases = cases;
        const auto report = session::run_session(named, store, {}, false);
        if (settings.json) {
            document = reports::cases_document(report);
        } else {
            print_cases(report, named);
            terminal::print_results("\n{}", reports::summary_tables(report));
        }
        code = close_session(report, named);
    }
    if (settings.json) {
        if (!phenomena.empty()) document["phenomena"] = std::move(tables);
        terminal::print_document(document);
    } else {
        terminal::print_result_text(text);
    }
    return code;
}

int certify_cases(const Settings& settings, std::stop_token stop) {
    Settings parity = settings;
    if (parity.cases.empty()) {
        parity.cases = session::certifiable_cases();
        if (settings.suite == catalog::Suite::full) parity.cases.push_back("attribution-friction");
    }
    store::Store store = session::open_store(settings, store::Access::write_later);
    const auto report = session::run_session(parity, store, std::move(stop), true);
    if (settings.json) {
        auto document = reports::certificate_document(report);
        document["attribution"] = studies::attribution_document(report);
        terminal::print_document(document);
    } else {
        const std::string certificate = reports::certificate_table(report);
        const std::string attribution = studies::attribution_table(report);
        const bool nothing = certificate.empty() && attribution.empty();
        terminal::print_results(
            "{}{}{}", nothing ? "no case with a parity check was selected\n" : certificate,
            reports::exceptions_list(report), attribution);
    }
    return close_session(report, parity);
}

int validate(const Settings& settings, std::stop_token stop) {
    store::Store store = session::open_store(settings, store::Access::write_later);
    const auto report = session::run_session(settings, store, std::move(stop), true);
    std::exception_ptr failure;
    if (!report.interrupted)
        failure = terminal::failure_of([&] { write_report_files(report, store, settings); });
    print_cases(report, settings);
    const int code = close_session(report, settings);
    if (failure) std::rethrow_exception(failure);
    if (!report.interrupted && !settings.quiet)
        terminal::print_note("report: {}",
                             reports::page_file(reports::Page::report, settings).string());
    return code;
}

int write_report(const Settings& settings, bool open) {
    store::Store store = session::open_store(settings, store::Access::read);
    const auto report = session::run_session(settings, store, {}, false);
    write_report_files(report, store, settings);
    const auto page = reports::page_file(reports::Page::report, settings);
    terminal::print_results("{}\n", page.string());
    if (open) open_in_browser(page);
    return exit_ok;
}

namespace {

int print_history(const Settings& settings, const std::vector<studies::HistorySeries>& history) {
    if (settings.json) {
        terminal::print_document(studies::history_document(history));
    } else {
        terminal::print_result_text(studies::history_table(history));
    }
    const bool drifts = std::ranges::any_of(
        history, [](const auto& series) { return series.drift == studies::Drift::left_band; });
    return drifts ? exit_verdict : exit_ok;
}

}  // namespace

int show_history(const Settings& settings) {
    store::Store store = session::open_store(settings, store::Access::read);
    return print_history(settings, studies::history_of(store.history()));
}

int show_regressions(const Settings& settings) {
    store::Store store = session::open_store(settings, store::Access::read);
    auto history = studies::history_of(store.history());
    const auto all = history.size();
    const auto young =
        std::ranges::count(history, studies::Drift::too_few, &studies::HistorySeries::drift);
    std::erase_if(history, [](const studies::HistorySeries& series) {
        return series.drift != studies::Drift::left_band;
    });
    if (!settings.json && history.empty()) {
        terminal::print_results(
            "no regression in {} series ({} of them have too few entries to judge)\n", all, young);
        return exit_ok;
    }
    return print_history(settings, history);
}

}  // namespace crossgrain::app
