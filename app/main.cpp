// The command line. Errors become one line on stderr and an exit code.
#include "adapters/registry/program_version.hpp"
#include "app/commands/commands.hpp"
#include "app/exit_code.hpp"
#include "app/option_rules.hpp"
#include "app/signal_stop.hpp"
#include "cases/toml/toml_table.hpp"
#include "native/base/errors.hpp"
#include "native/base/printable.hpp"
#include "reports/session/session.hpp"
#include "reports/terminal/output.hpp"
#include "reports/terminal/progress.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <new>
#include <sstream>
#include <stdexcept>
#include <stop_token>

namespace {

using namespace crossgrain;
using app::Settings;
using toml_input::TextKind;

struct Arguments {
    Settings settings;
    std::string suite;
    std::string out;
    app::ReadRequest read;
    bool open = false;
    std::vector<std::string> benches;
    bool quick_bench = false;
    app::AdviseRequest advise;
    app::SelftestRequest selftest;
};

void add_seed(CLI::App& command, Settings& settings, const char* text) {
    // The seeds of all replicas must fit the store's signed numbers.
    constexpr auto most =
        static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max() - catalog::most_runs);
    command.add_option("--seed", settings.seed, text)
        ->check(app::whole_number(0, most))
        ->capture_default_str();
}

void add_jobs(CLI::App& command, Settings& settings) {
    constexpr std::uint64_t most = 1000;
    command.add_option("--jobs", settings.jobs, "runs side by side (default: one per processor)")
        ->check(app::whole_number(1, most));
}

void add_selection(CLI::App& command, Arguments& arguments) {
    Settings& s = arguments.settings;
    command.add_option("CASE", s.cases, "cases by name or path of a case file (default: all)");
    command.add_option("--code", s.codes, "only this code (may be repeated)")
        ->allow_extra_args(false);
    command.add_option("--replicas", s.replicas, "runs per code, each with its own seed")
        ->check(app::whole_number(1, catalog::most_runs));
    add_seed(command, s, "seed of the first replica");
    command.add_option("--suite", arguments.suite, "size of the cases: quick or full")
        ->check(CLI::IsMember({"quick", "full"}));
}

void add_execution(CLI::App& command, Arguments& arguments) {
    Settings& s = arguments.settings;
    add_jobs(command, s);
    command.add_flag("--fresh", s.fresh, "compute again what the store already has");
    command.add_option("--time-limit", s.time_limit, "wall seconds per run")
        ->check(app::positive_number(1e9));
    command.add_flag("--keep-dumps", s.keep_dumps,
                     "keep inputs, logs and trajectories in <results>/runs, to be measured again");
}

using Action = std::function<int(Arguments&, std::stop_token)>;

/// Every command with its action, in the order of the help text.
std::map<CLI::App*, Action> add_commands(CLI::App& program, Arguments& a) {
    std::map<CLI::App*, Action> actions;
    const auto add = [&](const char* name, const char* text, Action action) {
        auto* command = program.add_subcommand(name, text);
        actions[command] = std::move(action);
        return command;
    };
    add("codes", "codes on this machine, their versions and what each can express",
        [](Arguments& x, auto stop) { return app::list_codes(x.settings, std::move(stop)); });
    add("cases", "cases of the catalogue",
        [](Arguments& x, auto) { return app::list_cases(x.settings); });
    add("observables", "what can be measured, and the exact values there are",
        [](Arguments& x, auto) { return app::list_observables(x.settings); });
    add("schema", "the JSON schema of case files, for editors",
        [](Arguments&, auto) { return app::print_schema(); });
    auto* run = add("run", "run cases and judge them", [](Arguments& x, std::stop_token stop) {
        return app::run_cases(x.settings, std::move(stop));
    });
    add_selection(*run, a);
    add_execution(*run, a);
    auto* write = add("write", "write the inputs of a code only", [](Arguments& x, auto stop) {
        return app::write_inputs(x.settings, x.out, std::move(stop));
    });
    add_selection(*write, a);
    write->add_option("--out", a.out, "directory to write to")
        ->required()
        ->check(app::printable_text(TextKind::line));
    auto* read = add("read", "measure a LAMMPS dump made elsewhere", [](Arguments& x, auto stop) {
        x.read.dump = x.settings.cases.back();
        x.settings.cases.pop_back();
        return app::read_dump(x.settings, x.read, std::move(stop));
    });
    read->add_option("CASE PATH", a.settings.cases, "the case, and the dump")
        ->required()
        ->expected(2);
    read->add_option("--code", a.read.name, "name of the code that made it")
        ->required()
        ->check(app::printable_text(TextKind::name));
    read->add_option("--variant", a.read.variant, "variant of the case (default: the first)")
        ->check(app::printable_text(TextKind::line));
    read->add_option("--rung", a.read.rung, "which time step of a ladder, from 1")
        ->check(app::whole_number(1, catalog::most_runs));
    add_seed(*read, a.settings, "seed of the initial state");
    auto* certify = add("certify", "certificate of equivalence between codes",
                        [](Arguments& x, std::stop_token stop) {
                            return app::certify_cases(x.settings, std::move(stop));
                        });
    add_selection(*certify, a);
    add_execution(*certify, a);
    auto* compare = add("compare", "verdicts from what the store holds",
                        [](Arguments& x, auto) { return app::compare_cases(x.settings); });
    add_selection(*compare, a);
    auto* report = add("report", "write the report pages from what the store holds",
                       [](Arguments& x, auto) { return app::write_report(x.settings, x.open); });
    add_selection(*report, a);
    report->add_flag("--open", a.open, "show the page in a browser");
    add("history", "every observable and cost over the store; exit code 1 on drift",
        [](Arguments& x, auto) { return app::show_history(x.settings); });
    add("regressions", "what left the band of its history; exit code 1 if anything did",
        [](Arguments& x, auto) { return app::show_regressions(x.settings); });
    auto* bench = add("bench", "speed side by side, in one run", [](Arguments& x, auto stop) {
        return app::run_benches(x.settings, x.benches, x.quick_bench, std::move(stop));
    });
    bench->add_option("NAME", a.benches, "lga, hopper, dem, dem-friction (default: all)");
    bench->add_flag("--quick", a.quick_bench, "shorter runs, figures are less certain");
    auto* stability =
        add("stability", "where methods stop working",
            [](Arguments& x, const auto& stop) { return app::map_stability(x.settings, stop); });
    add_selection(*stability, a);
    add_execution(*stability, a);
    stability
        ->add_option("--map", a.settings.map_axes,
                     "states over two parameters of the case's failure map, e.g. dt,restitution")
        ->delimiter(',')
        ->expected(1, 2);
    auto* chart =
        add("chart", "speed against accuracy: the ladders of cases",
            [](Arguments& x, const auto& stop) { return app::chart_cases(x.settings, stop); });
    add_selection(*chart, a);
    add_execution(*chart, a);
    auto* advise =
        add("advise", "the cheapest way to an observable within a tolerance, from the chart",
            [](Arguments& x, auto) { return app::advise_case(x.settings, x.advise); });
    advise->add_option("CASE", a.settings.cases, "the case")->required()->expected(1);
    advise->add_option("--code", a.settings.codes, "only this code (may be repeated)")
        ->allow_extra_args(false);
    advise->add_option("--observable", a.advise.observable, "its name, or the beginning of several")
        ->required();
    advise->add_option("--tolerance", a.advise.tolerance, "largest error, in the observable's unit")
        ->required()
        ->check(app::positive_number(1e300));
    auto* selftest = add("selftest", "error rates of the verdicts: false alarms, planted defects",
                         [](Arguments& x, std::stop_token stop) {
                             return app::selftest(x.settings, x.selftest, std::move(stop));
                         });
    selftest->add_option("--defects", a.selftest.defects, "directory of defects and null cases")
        ->check(CLI::ExistingDirectory);
    selftest->add_flag("--quick", a.selftest.quick, "a small part: seconds, figures mean little");
    add_jobs(*selftest, a.settings);
    selftest->add_flag("--fresh", a.settings.fresh, "compute again what the store already has");
    auto* validate = add("validate", "run a suite, judge it, write the report",
                         [](Arguments& x, std::stop_token stop) {
                             return app::validate(x.settings, std::move(stop));
                         });
    add_selection(*validate, a);
    add_execution(*validate, a);
    return actions;
}

/// validate, report and compare are about the quick suite unless told otherwise; the others about
/// the case as it is written.
void choose_suite(const CLI::App& command, Arguments& arguments) {
    const std::string& name = command.get_name();
    const bool quick_by_default = name == "validate" || name == "report" || name == "compare";
    const bool quick = arguments.suite.empty() ? quick_by_default : arguments.suite == "quick";
    arguments.settings.suite = quick ? catalog::Suite::quick : catalog::Suite::full;
}

constexpr std::size_t longest_message = 1000;

/// Whether the command has nothing to bring to an orderly end.
bool only_reads(const CLI::App& command) {
    constexpr std::array names{"cases",  "observables", "schema",      "compare",
                               "report", "history",     "regressions", "advise"};
    return std::ranges::find(names, command.get_name()) != names.end();
}

/// What was wrong with the command line. CLI11 misses a command before it looks at the words that
/// are left.
std::string complaint_of(const CLI::App& program, const CLI::ParseError& error) {
    const auto left = program.remaining();
    if (left.empty() || error.get_exit_code() != static_cast<int>(CLI::ExitCodes::RequiredError))
        return printable(error.what(), longest_message);
    std::vector<std::string> commands;
    for (const auto* command : program.get_subcommands({}))
        commands.push_back(command->get_name());
    const auto near = toml_input::nearest(left.front(), commands);
    return fmt::format("'{}' is no command or option{}", printable(left.front(), longest_message),
                       near ? fmt::format(", did you mean '{}'?", *near) : "");
}

int run_program(int argc, char** argv, app::SignalStop& stop) {
    CLI::App program{"crossgrain: cross-validation of granular codes"};
    program.set_version_flag("--version", adapters::program_version());
    program.require_subcommand(1);
    program.fallthrough();
    Arguments arguments;
    Settings& settings = arguments.settings;
    program.add_option("--results", settings.results, "directory of store and report")
        ->check(app::printable_text(TextKind::line))
        ->capture_default_str();
    program.add_flag("--json", settings.json, "one JSON document on stdout");
    program.add_flag("--quiet", settings.quiet, "no progress");
    settings.command = app::command_text({argv + 1, argv + argc});
    const auto actions = add_commands(program, arguments);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        std::ostringstream text, complaint;
        const bool asked = program.exit(error, text, complaint) == 0;  // for help or the version
        terminal::print_result_text(text.str());
        if (asked) return app::exit_ok;
        terminal::print_note("error: {}; see 'crossgrain --help'", complaint_of(program, error));
        return app::exit_usage;
    }
    auto* command = program.get_subcommands().front();
    choose_suite(*command, arguments);
    terminal::TerminalMonitor monitor(settings.quiet);
    settings.monitor = &monitor;
    return actions.at(command)(arguments, only_reads(*command) ? std::stop_token() : stop.listen());
}

/// One line on stderr, and the exit code. What fails after a stop request fails because of it: it
/// interrupts system calls that wait.
int failed(const std::exception& error, int code, const app::SignalStop& stop) {
    terminal::flush_results();  // where both go to one file, the results come first
    if (stop.requested()) {
        terminal::print_note("interrupted");
        return app::exit_interrupted;
    }
    terminal::print_note("error: {}", error.what());
    return code;
}

int guarded_run(int argc, char** argv, app::SignalStop& stop) {
    try {
        return run_program(argc, argv, stop);
    } catch (const CaseError& error) {
        return failed(error, app::exit_usage, stop);
    } catch (const store::StoreError& error) {
        return failed(error, app::exit_usage, stop);
    } catch (const std::bad_alloc&) {
        // Runs that fail are told as such where they fail: this is about what was being planned.
        return failed(std::runtime_error("the input asks for more memory than there is"),
                      app::exit_usage, stop);
    } catch (const std::length_error& error) {
        return failed(std::runtime_error(fmt::format(
                          "the input asks for more than can be counted: {}", error.what())),
                      app::exit_usage, stop);
    } catch (const std::exception& error) {
        return failed(error, app::exit_run_failed, stop);
    }
}

}  // namespace

int main(int argc, char** argv) {
    terminal::open_standard_streams();
    app::SignalStop stop;
    const int code = guarded_run(argc, argv, stop);
    if (const auto reason = terminal::lost_results()) {
        terminal::print_note("error: standard output cannot be written: {}", *reason);
        return code == app::exit_interrupted ? code : app::exit_run_failed;
    }
    return code;
}
