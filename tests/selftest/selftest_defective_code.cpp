#include "tests/selftest/selftest_defective_code.hpp"

#include "native/base/errors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace crossgrain::selftest {

ScenePairs::ScenePairs(const catalog::Case& honest, const catalog::Case& changed,
                       std::uint64_t seed, std::int64_t replicas, const std::string& place) {
    const bool alike =
        std::equal(honest.variants.begin(), honest.variants.end(), changed.variants.begin(),
                   changed.variants.end(), [](const auto& a, const auto& b) {
                       return a.name == b.name && a.rungs == b.rungs;
                   });
    if (!alike) {
        throw CaseError({.file = place,
                         .problem = "changes the variants or time steps of the case",
                         .expected = "the same runs, done wrongly"});
    }
    for (std::size_t variant = 0; variant < honest.variants.size(); ++variant) {
        for (std::size_t rung = 0; rung < honest.variants[variant].rungs; ++rung) {
            for (std::int64_t replica = 0; replica < replicas; ++replica) {
                const std::uint64_t own = seed + static_cast<std::uint64_t>(replica);
                changed_.emplace(scene::identity_json(honest.scene(variant, rung, own)).dump(),
                                 changed.scene(variant, rung, own));
            }
        }
    }
}

const scene::AnyScene& ScenePairs::find(const scene::AnyScene& scene) const {
    return changed_.at(scene::identity_json(scene).dump());
}

template <class SceneT>
void DefectiveCode<SceneT>::edit(std::vector<adapters::InputFile>& files) const {
    const auto file = std::find_if(files.begin(), files.end(),
                                   [&](const auto& f) { return f.name == defect_.file; });
    if (file == files.end()) {
        throw CaseError({.file = defect_.place,
                         .key = "defect.file",
                         .problem = fmt::format("is no input of {}", code_.name()),
                         .got = defect_.file});
    }
    file->text = edited(file->text, defect_.edit, defect_.place);
}

namespace {

template <class SceneT>
std::unique_ptr<adapters::Code> made_for(const adapters::Code& honest, const adapters::Code& runs,
                                         const Defect& defect, ScenePairs scenes) {
    return std::make_unique<DefectiveCode<SceneT>>(
        dynamic_cast<const adapters::CodeFor<SceneT>&>(honest),
        dynamic_cast<const adapters::CodeFor<SceneT>&>(runs), defect, std::move(scenes));
}

}  // namespace

std::unique_ptr<adapters::Code> make_defective(const adapters::Code& honest,
                                               const adapters::Code& runs, const Defect& defect,
                                               ScenePairs scenes, const std::string& model) {
    if (model == "lattice-gas") {
        return made_for<scene::LatticeGas>(honest, runs, defect, std::move(scenes));
    }
    if (model == "hopper-automaton") {
        return made_for<scene::HopperAutomaton>(honest, runs, defect, std::move(scenes));
    }
    if (model == "synthetic-signal") {
        return made_for<scene::SyntheticSignal>(honest, runs, defect, std::move(scenes));
    }
    return made_for<scene::Scene>(honest, runs, defect, std::move(scenes));
}

}  // namespace crossgrain::selftest
