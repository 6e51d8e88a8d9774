// The project's own engines for Gremaud's hopper automaton behind the interface of all codes.
#pragma once

#include "adapters/code.hpp"

namespace crossgrain::adapters {

class NativeHopperCode final : public HopperCode {
  public:
    /// `version` identifies the build, e.g. "0.1.0 (engine 1a2b3c4d)".
    explicit NativeHopperCode(std::string version);

    [[nodiscard]] std::string name() const override { return "native-hopper"; }
    [[nodiscard]] Availability probe(std::stop_token = {}) const override;
    [[nodiscard]] std::vector<std::string> features() const override;
    /// What the engine refuses (native/hopper/parameters.hpp, check()).
    [[nodiscard]] std::optional<std::string>
    cannot_express(const scene::HopperAutomaton& scene) const override;
    /// The scene itself, as JSON: the engine has no other input.
    [[nodiscard]] std::vector<InputFile> input(const scene::HopperAutomaton& scene) const override;
    /// Angle after angle, each with its replicas, each with its frames. A kept dump is
    /// <directory>/dump.csv: a row per frame with what has left and how far the walls have moved.
    RunCost run(const scene::HopperAutomaton& scene, const RunOptions& options,
                const Sink& sink) const override;

  private:
    std::string version_;
};

}  // namespace crossgrain::adapters
