// crossgrain codes | cases | observables | schema: what is there.
#include "adapters/registry/codes.hpp"
#include "app/commands/commands.hpp"
#include "app/exit_code.hpp"
#include "cases/catalog/case_schema.hpp"
#include "cases/observables/observables.hpp"
#include "native/base/share_directory.hpp"
#include "reference/oracles/oracles.hpp"
#include "reports/documents/documents.hpp"
#include "reports/documents/text_table.hpp"
#include "reports/session/session.hpp"
#include "reports/terminal/output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace crossgrain::app {
namespace {

/// "/usr/bin/lmp 0123456789ab": where it is, and the beginning of its digest.
std::string program_text(const nlohmann::json& code) {
    constexpr std::size_t digits = 12;
    const auto program = code["program"].get<std::string>();
    if (program.empty()) return {};
    return fmt::format("{} {}", program, code["digest"].get<std::string>().substr(0, digits));
}

}  // namespace

int list_codes(const Settings& settings, std::stop_token stop) {
    const auto document = reports::codes_document(std::move(stop));
    if (settings.json) {
        terminal::print_document(document);
        return exit_ok;
    }
    reports::TextTable table({"code", "status", "version", "program", "expresses"});
    for (const auto& code : document["codes"]) {
        bool first = true;
        for (const std::string feature : code["expresses"]) {
            table.add({first ? code["code"].get<std::string>() : "",
                       first ? code["status"].get<std::string>() : "",
                       first ? (code["status"] == "ok" ? code["version"].get<std::string>()
                                                       : code["reason"].get<std::string>())
                             : "",
                       first ? program_text(code) : "", feature});
            first = false;
        }
    }
    terminal::print_result_text(table.text(0));
    return exit_ok;
}

int list_cases(const Settings& settings) {
    const std::string directory = (share_directory() / "catalog").string();
    nlohmann::json list = nlohmann::json::array();
    reports::TextTable table({"case", "suites", "title", "source"});
    for (const auto& name : catalog::case_names(directory)) {
        const auto found = catalog::find_case(directory, name, settings.suite);
        nlohmann::json variants = nlohmann::json::array();
        for (const auto& variant : found.variants)
            variants.push_back(variant.name);
        list.push_back({{"case", found.name},
                        {"model", found.model},
                        {"title", found.title},
                        {"source", found.source},
                        {"suites", found.suites},
                        {"variants", std::move(variants)}});
        table.add({found.name, fmt::format("{}", fmt::join(found.suites, ", ")), found.title,
                   found.source});
    }
    if (settings.json) {
        terminal::print_document({{"cases", std::move(list)}});
    } else {
        terminal::print_result_text(table.text(0));
    }
    return exit_ok;
}

int list_observables(const Settings& settings) {
    nlohmann::json list = nlohmann::json::array();
    reports::TextTable table({"observable", "model", "measures", "options"});
    for (const auto& entry : observables::observable_texts()) {
        std::vector<std::string> options;
        for (const auto& option : entry.options)
            options.push_back(option.name);
        list.push_back({{"observable", entry.name},
                        {"model", entry.model},
                        {"measures", entry.measures},
                        {"options", options}});
        table.add(
            {entry.name, entry.model, entry.measures, fmt::format("{}", fmt::join(options, ", "))});
    }
    if (settings.json) {
        terminal::print_document(
            {{"observables", std::move(list)}, {"oracles", oracles::oracle_names()}});
    } else {
        terminal::print_results("{}\noracles: {}\n", table.text(0),
                                fmt::join(oracles::oracle_names(), ", "));
    }
    return exit_ok;
}

int print_schema() {
    std::vector<std::string> names;
    for (const auto& code : adapters::codes())
        names.push_back(code->name());
    std::map<std::string, std::vector<catalog::ObservableWords>> by_model;
    for (const auto& entry : observables::observable_texts())
        by_model[entry.model].push_back({entry.name, entry.options, entry.measures});
    // Signals are what the lattice gas's estimators are calibrated with.
    by_model["synthetic-signal"] = by_model["lattice-gas"];
    terminal::print_document(catalog::case_schema(names, by_model));
    return exit_ok;
}

}  // namespace crossgrain::app
