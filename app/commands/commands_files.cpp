// crossgrain write | read: hand a scene's inputs out, take trajectories made elsewhere in.
#include "adapters/registry/codes.hpp"
#include "adapters/run/measured_dump.hpp"
#include "adapters/run/model_runs.hpp"
#include "adapters/run/plan.hpp"
#include "adapters/run/preparation.hpp"
#include "adapters/run/written_input.hpp"
#include "app/commands/commands.hpp"
#include "app/exit_code.hpp"
#include "native/base/share_directory.hpp"
#include "reference/judge/evaluate.hpp"
#include "reports/documents/documents.hpp"
#include "reports/documents/tables.hpp"
#include "reports/session/session.hpp"
#include "reports/terminal/output.hpp"

#include "cases/toml/toml_table.hpp"
#include "native/base/errors.hpp"
#include "reports/documents/atomic_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace crossgrain::app {
namespace {

std::shared_ptr<const catalog::Case> the_one_case(const Settings& settings,
                                                  const std::stop_token& stop) {
    if (settings.cases.size() != 1) {
        throw CaseError({.problem = "needs one case",
                         .got = fmt::format("{}", settings.cases.size()),
                         .expected = "exactly one case"});
    }
    return session::selected_cases(settings, stop).front();
}

std::size_t variant_index(const catalog::Case& the_case, const std::string& name) {
    if (name.empty()) return 0;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < the_case.variants.size(); ++i) {
        if (the_case.variants[i].name == name) return i;
        names.push_back(the_case.variants[i].name);
    }
    const auto near = toml_input::nearest(name, names);
    throw CaseError({.file = the_case.file,
                     .key = "variant",
                     .problem = "is not known",
                     .got = fmt::format("'{}'", name),
                     .expected = "a variant of the case",
                     .hint = near ? fmt::format("did you mean '{}'?", *near) : ""});
}

}  // namespace

int write_inputs(const Settings& settings, const std::filesystem::path& out, std::stop_token stop) {
    if (settings.codes.size() != 1) {
        throw CaseError({.key = "--code",
                         .problem = "is needed once",
                         .got = fmt::format("{} codes", settings.codes.size()),
                         .expected = "the code whose input to write"});
    }
    const auto the_case = the_one_case(settings, stop);
    const auto runs = run::plan(*the_case, adapters::select_codes(settings.codes), settings, stop);
    std::vector<const run::PlannedRun*> expressible;
    for (const auto& run : runs) {
        if (const auto reason = run::cannot_express(*run.code, *run.scene)) {
            terminal::print_note("not_expressible: {}: {}", scene::name_of(*run.scene), *reason);
        } else {
            expressible.push_back(&run);
        }
    }
    const auto names = run::input_directory_names(expressible);
    run::Preparations preparations = run::preparations_in(settings);
    std::vector<run::WrittenInput> inputs;
    for (std::size_t i = 0; i < expressible.size(); ++i) {
        const run::PlannedRun& run = *expressible[i];
        const auto ready = preparations.prepared(run.scene, run.time_limit, stop);
        inputs.push_back({.directory = out / names[i], .files = run::input_of(*run.code, *ready)});
        run::prepare_directory(inputs.back());
    }
    for (const auto& [directory, files] : inputs) {
        for (const auto& file : files)
            reports::write_file_atomically(directory / file.name, file.text);
        terminal::print_results("{}\n", directory.string());
    }
    return inputs.empty() ? exit_run_failed : exit_ok;
}

int read_dump(const Settings& settings, const ReadRequest& request, std::stop_token stop) {
    const auto the_case = the_one_case(settings, stop);
    if (the_case->model != "grains") {
        throw CaseError({.file = the_case->file,
                         .key = "read",
                         .problem = fmt::format("is a case of a {}", the_case->model),
                         .expected = "a case of grains: only these have dumps"});
    }
    const std::size_t variant = variant_index(*the_case, request.variant);
    if (request.rung < 1 || request.rung > the_case->variants[variant].rungs) {
        throw CaseError({.key = "--rung",
                         .problem = "is out of range",
                         .got = std::to_string(request.rung),
                         .expected = fmt::format("1 to {}", the_case->variants[variant].rungs)});
    }
    store::Store store = session::open_store(settings, store::Access::read_if_there);
    // The other codes' runs of the same scene, as far as the store has them, to compare with.
    Settings stored = settings;
    stored.codes.clear();
    auto session = session::run_session(stored, store, {}, false);
    std::vector<store::RunRecord> records{run::measure_dump(
        *the_case,
        {.file = request.dump, .name = request.name, .variant = variant, .rung = request.rung - 1},
        settings, stop)};
    const bool failed = records.front().status != store::RunStatus::ok;
    for (const auto& run : session.cases.front().runs.records()) {
        const bool sibling =
            run.status == store::RunStatus::ok && run.variant == records.front().variant;
        if (sibling && run.code != request.name) records.push_back(run);
    }
    const published::PublishedValues literature(share_directory() / "published");
    judge::CaseRuns runs(*the_case, std::move(records));
    judge::Evaluation evaluation = judge::evaluate(runs, literature);
    std::erase_if(evaluation.verdicts, [&](const compare::Verdict& v) {
        return v.code != request.name && v.against.name != request.name;
    });
    session::SessionReport report{.cases = {{the_case, std::move(runs), std::move(evaluation)}}};
    if (settings.json) {
        terminal::print_document(reports::cases_document(report));
    } else {
        terminal::print_results("{}\n{}", reports::case_table(report.cases.front()),
                                reports::exceptions_list(report));
    }
    if (!failed) return exit_code(report, settings);
    // Not a run of ours that failed: the dump is bad input.
    terminal::flush_results();
    terminal::print_note("error: {}", report.cases.front().runs.records().front().reason);
    return exit_usage;
}

}  // namespace crossgrain::app
