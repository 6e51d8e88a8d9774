#include "adapters/run/plan.hpp"

#include "adapters/registry/codes.hpp"
#include "adapters/registry/source_keys.hpp"
#include "adapters/run/model_runs.hpp"
#include "cases/observables/observables.hpp"
#include "native/base/digest.hpp"
#include "native/base/errors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace crossgrain::run {
namespace {

nlohmann::json observables_json(const catalog::Case& the_case) {
    nlohmann::json all = nlohmann::json::array();
    for (const auto& request : the_case.observables) {
        nlohmann::json options = nlohmann::json::object();
        for (const auto& [name, option] : request.options) {
            options[name] = {option.numbers, option.text};
        }
        all.push_back({request.name, options});
    }
    return all;
}

/// Decides what can be said without running: absent codes and scenes a code cannot express.
void settle_without_running(PlannedRun& run, const adapters::Availability& available) {
    auto& record = run.record;
    record.version = available.version;
    record.program = available.program;
    record.digest = available.digest;
    if (!available.installed) {
        record.status = store::RunStatus::not_installed;
        record.reason = available.reason;
    } else if (const auto refusal = cannot_express(*run.code, *run.scene)) {
        record.status = store::RunStatus::not_expressible;
        record.reason = *refusal;
    } else {
        record.status = store::RunStatus::planned;
        record.key = run_key(run);
    }
}

PlannedRun planned_run(const catalog::Case& the_case, const adapters::Code& code,
                       std::shared_ptr<const scene::AnyScene> scene, const Settings& settings) {
    PlannedRun run{.owner = &the_case,
                   .code = &code,
                   .scene = std::move(scene),
                   .time_limit = settings.time_limit.value_or(the_case.time_limit)};
    run.record.case_name = the_case.name;
    run.record.code = code.name();
    run.record.seed = scene::seed_of(*run.scene);
    run.record.settings_json = scene::settings_json(*run.scene).dump();
    auto [amount, unit] = scene::work_of(*run.scene);
    run.record.work = amount;
    run.record.work_unit = std::move(unit);
    return run;
}

std::vector<const adapters::Code*> codes_for(const catalog::Case& the_case,
                                             const std::vector<const adapters::Code*>& selected) {
    std::vector<const adapters::Code*> suited;
    for (const auto* code : selected) {
        if (runs_model(*code, the_case.model)) suited.push_back(code);
    }
    if (suited.empty()) {
        throw CaseError({.file = the_case.file,
                         .key = "--code",
                         .problem = fmt::format("names no code that runs a {}", the_case.model),
                         .expected = "a code of the case's model",
                         .hint = "see 'crossgrain codes'"});
    }
    return suited;
}

/// What decides the frames of this scene.
nlohmann::json frames_identity(const PlannedRun& run, scene::AnyScene scene) {
    // The scene's name is a label: renaming a case must not recompute it.
    std::visit([](auto& s) { s.name.clear(); }, scene);
    nlohmann::json identity{{"scene", scene::identity_json(scene)},
                            {"code", run.code->name()},
                            {"version", run.record.version},
                            {"digest", run.record.digest},
                            {"sources", adapters::code_source_key(run.code->name())}};
    for (const auto& file : input_of(*run.code, scene))
        identity["input"][file.name] = file.text;
    return identity;
}

}  // namespace

std::string run_key(const PlannedRun& run) {
    nlohmann::json identity = frames_identity(run, *run.scene);
    identity["observables"] = observables_json(*run.owner);
    identity["estimators"] = adapters::source_key(observables::source_folders(*run.owner));
    return sha256(identity.dump());
}

std::string frames_key(const PlannedRun& run, const scene::AnyScene& ready) {
    return sha256(frames_identity(run, ready).dump());
}

std::vector<PlannedRun> plan(const catalog::Case& the_case,
                             const std::vector<const adapters::Code*>& selected,
                             const Settings& settings, const std::stop_token& stop) {
    const auto codes = codes_for(the_case, selected);
    std::map<const adapters::Code*, adapters::Availability> availability;
    std::int64_t most = 0;
    const auto replicas_of = [&](const adapters::Code* code, const catalog::Variant& variant) {
        return settings.replicas.value_or(the_case.replicas.of(code->name(), variant.name));
    };
    for (const auto* code : codes) {
        availability[code] = code->probe(stop);
        for (const auto& variant : the_case.variants)
            most = std::max(most, replicas_of(code, variant));
    }
    std::vector<PlannedRun> runs;
    for (std::size_t variant = 0; variant < the_case.variants.size(); ++variant) {
        for (std::size_t rung = 0; rung < the_case.variants[variant].rungs; ++rung) {
            for (std::int64_t replica = 0; replica < most; ++replica) {
                if (stop.stop_requested()) throw Interrupted();
                const auto scene = std::make_shared<const scene::AnyScene>(the_case.scene(
                    variant, rung, settings.seed + static_cast<std::uint64_t>(replica)));
                for (const auto* code : codes) {
                    if (replica >= replicas_of(code, the_case.variants[variant])) continue;
                    PlannedRun run = planned_run(the_case, *code, scene, settings);
                    run.variant = variant;
                    run.rung = rung;
                    run.replica = replica;
                    run.record.variant = the_case.variants[variant].name;
                    run.record.rung = rung;
                    run.record.replica = replica;
                    settle_without_running(run, availability[code]);
                    runs.push_back(std::move(run));
                }
            }
        }
    }
    return runs;
}

}  // namespace crossgrain::run
