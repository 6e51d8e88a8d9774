// Generates signals with a known answer as the frames of a gas, to calibrate estimators with.
#pragma once

#include "adapters/code.hpp"

namespace crossgrain::adapters {

/// Every bin of every replica is synthesised as a whole (coloured_noise.hpp) and kept in 16 bits
/// until its frames are streamed: 2 bytes x bins x replicas x frames, at most 2^30 bytes; longer
/// signals are not expressible.
class SyntheticSignalCode final : public SignalCode {
  public:
    /// `version` identifies the build.
    explicit SyntheticSignalCode(std::string version);

    [[nodiscard]] std::string name() const override { return "synthetic"; }
    [[nodiscard]] Availability probe(std::stop_token = {}) const override;
    [[nodiscard]] std::vector<std::string> features() const override;
    [[nodiscard]] std::optional<std::string>
    cannot_express(const scene::SyntheticSignal& signal) const override;
    /// The scene itself, as JSON.
    [[nodiscard]] std::vector<InputFile> input(const scene::SyntheticSignal& signal) const override;
    RunCost run(const scene::SyntheticSignal& signal, const RunOptions& options,
                const Sink& sink) const override;

  private:
    std::string version_;
};

}  // namespace crossgrain::adapters
