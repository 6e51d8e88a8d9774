// The project's own distinct-element engine behind the interface of all codes.
#pragma once

#include "adapters/code.hpp"

namespace crossgrain::adapters {

class NativeDemCode final : public GrainCode {
  public:
    /// `version` identifies the build, e.g. "0.1.0 (engine 1a2b3c4d)".
    explicit NativeDemCode(std::string version);

    [[nodiscard]] std::string name() const override { return "native-dem"; }
    [[nodiscard]] Availability probe(std::stop_token = {}) const override;
    [[nodiscard]] std::vector<std::string> features() const override;
    [[nodiscard]] std::optional<std::string>
    cannot_express(const scene::Scene& scene) const override;
    /// The scene itself, as JSON: the engine has no other input.
    [[nodiscard]] std::vector<InputFile> input(const scene::Scene& scene) const override;
    RunCost run(const scene::Scene& scene, const RunOptions& options,
                const scene::FrameSink& sink) const override;

  private:
    std::string version_;
};

}  // namespace crossgrain::adapters
