// A code with a defect planted in it, while everybody else believes in it: it bears the code's
// name, is given the scene of the case, and something else happens.
#pragma once

#include "adapters/code.hpp"
#include "cases/catalog/case.hpp"
#include "cases/scene/frame_guard.hpp"
#include "tests/selftest/selftest_catalogue.hpp"
#include "tests/selftest/selftest_frames.hpp"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <string>

namespace crossgrain::selftest {

/// Scenes of a case as they are, and as they are with the defect in the case's file.
class ScenePairs {
  public:
    /// Nothing is changed.
    ScenePairs() = default;
    /// Both cases must have the same variants and time steps. Throws CaseError, naming `place`.
    ScenePairs(const catalog::Case& honest, const catalog::Case& changed, std::uint64_t seed,
               std::int64_t replicas, const std::string& place);

    /// The changed scene that belongs to this one.
    template <class SceneT>
    [[nodiscard]] SceneT of(const SceneT& scene) const {
        if (changed_.empty()) return scene;
        return std::get<SceneT>(find(scene));
    }

  private:
    [[nodiscard]] const scene::AnyScene& find(const scene::AnyScene& scene) const;
    std::map<std::string, scene::AnyScene> changed_;  ///< by the identity of the honest scene
};

template <class SceneT>
class DefectiveCode final : public adapters::CodeFor<SceneT> {
  public:
    using Sink = typename adapters::CodeFor<SceneT>::Sink;
    using Frame = typename adapters::CodeFor<SceneT>::Frame;

    /// `code` bears the name, `runs` does the work (the same, unless frames are borrowed).
    DefectiveCode(const adapters::CodeFor<SceneT>& code, const adapters::CodeFor<SceneT>& runs,
                  const Defect& defect, ScenePairs scenes)
        : code_(code), runs_(runs), defect_(defect), scenes_(std::move(scenes)) {}

    [[nodiscard]] std::string name() const override { return code_.name(); }
    [[nodiscard]] std::vector<std::string> features() const override { return code_.features(); }
    /// The version tells the defect, so that no run is taken for one without it.
    [[nodiscard]] adapters::Availability probe(std::stop_token stop = {}) const override {
        auto available = runs_.probe(std::move(stop));
        available.version += fmt::format(" with '{}'", defect_.name);
        return available;
    }
    [[nodiscard]] std::optional<std::string> cannot_express(const SceneT& scene) const override {
        return runs_.cannot_express(scenes_.of(scene));
    }
    [[nodiscard]] std::vector<adapters::InputFile> input(const SceneT& scene) const override {
        auto files = runs_.input(scenes_.of(scene));
        if (defect_.kind == DefectKind::input) edit(files);
        return files;
    }
    adapters::RunCost run(const SceneT& scene, const adapters::RunOptions& options,
                          const Sink& sink) const override {
        const SceneT changed = scenes_.of(scene);
        adapters::RunOptions own = options;
        if (defect_.kind == DefectKind::input) own.input = input(scene);
        if constexpr (std::is_same_v<SceneT, scene::Scene>) {
            // As in every adapter: what comes out is judged by what the scene asked for.
            scene::FrameGuard guard(scene, sink);
            const auto cost = runs_.run(changed, own, spoiled(scene, std::ref(guard)));
            guard.finish();
            return cost;
        } else {
            return runs_.run(changed, own, spoiled(scene, sink));
        }
    }

  private:
    [[nodiscard]] Sink spoiled(const SceneT& scene, Sink sink) const {
        if (defect_.kind != DefectKind::frames) return sink;
        return frame_filter(defect_.filter, scene, std::move(sink), defect_.place);
    }
    void edit(std::vector<adapters::InputFile>& files) const;

    const adapters::CodeFor<SceneT>& code_;
    const adapters::CodeFor<SceneT>& runs_;
    const Defect& defect_;
    ScenePairs scenes_;
};

/// The code of that defect for the case's model. `honest` must be of that model; so must the lender
/// of borrowed frames, if any (`runs`).
[[nodiscard]] std::unique_ptr<adapters::Code>
make_defective(const adapters::Code& honest, const adapters::Code& runs, const Defect& defect,
               ScenePairs scenes, const std::string& model);

}  // namespace crossgrain::selftest
