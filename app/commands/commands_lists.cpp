// crossgrain codes | cases | observables | schema: what is there.
#include "app/catalogue/catalogue.hpp"
#include "app/commands/commands.hpp"
#include "app/documents.hpp"
#include "app/output.hpp"
#include "app/session.hpp"
#include "app/text_table.hpp"
#include "cases/catalog/case_schema.hpp"

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
    const auto document = codes_document(std::move(stop));
    if (settings.json) {
        print_document(document);
        return exit_ok;
    }
    TextTable table({"code", "status", "version", "program", "expresses"});
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
    print_result_text(table.text(0));
    return exit_ok;
}

int list_cases(const Settings& settings) {
    const std::string directory = (share_directory() / "catalog").string();
    nlohmann::json list = nlohmann::json::array();
    TextTable table({"case", "suites", "title", "source"});
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
        print_document({{"cases", std::move(list)}});
    } else {
        print_result_text(table.text(0));
    }
    return exit_ok;
}

int list_observables(const Settings& settings) {
    nlohmann::json list = nlohmann::json::array();
    TextTable table({"observable", "model", "measures", "options"});
    for (const auto& entry : observable_texts()) {
        list.push_back({{"observable", entry.name},
                        {"model", entry.model},
                        {"measures", entry.measures},
                        {"options", entry.options}});
        table.add({entry.name, entry.model, entry.measures,
                   fmt::format("{}", fmt::join(entry.options, ", "))});
    }
    if (settings.json) {
        print_document({{"observables", std::move(list)}, {"oracles", oracle_names()}});
    } else {
        print_results("{}\noracles: {}\n", table.text(0), fmt::join(oracle_names(), ", "));
    }
    return exit_ok;
}

int print_schema() {
    std::vector<std::string> names;
    for (const auto& code : codes())
        names.push_back(code->name());
    std::map<std::string, std::vector<catalog::ObservableWords>> observables;
    for (const auto& entry : observable_texts())
        observables[entry.model].push_back({entry.name, entry.options, entry.measures});
    // Signals are what the lattice gas's estimators are calibrated with.
    observables["synthetic-signal"] = observables["lattice-gas"];
    print_document(catalog::case_schema(names, observables));
    return exit_ok;
}

}  // namespace crossgrain::app
