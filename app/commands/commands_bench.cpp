// crossgrain bench: speed side by side, in one run.
#include "app/commands/commands.hpp"
#include "app/exit_code.hpp"
#include "reports/session/session.hpp"
#include "reports/terminal/output.hpp"
#include "tests/bench/bench.hpp"

#include <nlohmann/json.hpp>

namespace crossgrain::app {

using nlohmann::json;

int run_benches(const Settings& settings, const std::vector<std::string>& names, bool quick,
                std::stop_token stop) {
    std::vector<const bench::Bench*> chosen;
    for (const auto& name : names)
        chosen.push_back(&bench::bench_named(name));
    if (names.empty()) {
        for (const auto& bench : bench::benches())
            chosen.push_back(&bench);
    }
    json documents = json::array();
    for (const bench::Bench* bench : chosen) {
        if (!settings.quiet) terminal::print_note("bench {}: {}", bench->name, bench->title);
        const auto progress = [&](const std::string& line) {
            if (!settings.quiet) terminal::print_note("  {}", line);
        };
        const bench::BenchReport report =
            bench->run({.quick = quick, .stop = stop, .progress = progress});
        if (settings.json) {
            documents.push_back(bench::bench_json(*bench, report));
            continue;
        }
        terminal::print_result_text(bench::bench_text(*bench, report));
    }
    if (settings.json) {
        // One bench is one document, as scripts expect it; several are a list.
        terminal::print_document(documents.size() == 1 ? documents.front() : documents);
    }
    return stop.stop_requested() ? exit_interrupted : exit_ok;
}

}  // namespace crossgrain::app
