// The project's own lattice gas engines behind the interface of all codes.
#pragma once

#include "adapters/code.hpp"

namespace crossgrain::adapters {

class NativeGasCode final : public GasCode {
  public:
    /// `version` identifies the build, e.g. "0.1.0 (engine 1a2b3c4d)".
    explicit NativeGasCode(std::string version);

    [[nodiscard]] std::string name() const override { return "native-lga"; }
    [[nodiscard]] Availability probe(std::stop_token = {}) const override;
    [[nodiscard]] std::vector<std::string> features() const override;
    [[nodiscard]] std::optional<std::string>
    cannot_express(const scene::LatticeGas& scene) const override;
    /// The scene itself, as JSON: the engines have no other input.
    [[nodiscard]] std::vector<InputFile> input(const scene::LatticeGas& scene) const override;
    /// A kept dump is <directory>/frames.csv: one line per frame, bin and replica.
    /// Throws AdapterError when a replica saturates and the scene says OnSaturation::fail, and for
    /// rules that do not conserve.
    RunCost run(const scene::LatticeGas& scene, const RunOptions& options,
                const Sink& sink) const override;

  private:
    std::string version_;
};

}  // namespace crossgrain::adapters
