// Searches for the largest time step at which a code's integration of a packing stays stable.
#pragma once

#include "adapters/code.hpp"
#include "adapters/run/settings.hpp"
#include "adapters/run/store/store.hpp"
#include "reports/studies/stability/stability.hpp"

#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

namespace crossgrain::studies {

/// A time step fails if the energy rises this many times above its least value within so many
/// steps.
inline constexpr double rise_of_trial = 3;
inline constexpr std::int64_t steps_of_trial = 6000;

/// Runs scenes in a code; nothing of a run is kept but what the sink keeps.
class StabilityTrial {
  public:
    /// `directory`: every run gets one of its own below it.
    StabilityTrial(const adapters::GrainCode& code, std::filesystem::path directory,
                   std::stop_token stop)
        : code_(&code), directory_(std::move(directory)), stop_(std::move(stop)) {}

    [[nodiscard]] const adapters::GrainCode& code() const noexcept { return *code_; }

    /// Whether the run came to its end; false if the trajectory left all bounds. Throws
    /// Interrupted.
    bool run(const scene::Scene& scene, const scene::FrameSink& sink) const;

  private:
    const adapters::GrainCode* code_;
    std::filesystem::path directory_;
    std::stop_token stop_;
};

/// One threshold to be found.
struct ThresholdSearch {
    const adapters::GrainCode* code = nullptr;
    std::string version, digest;  ///< of the code (adapters::Availability)
    scene::Scene packing;
    double guess = 0;           ///< of the threshold, > 0
    StabilityThreshold result;  ///< all but `works` and `fails`
};

/// Finds thresholds to half a percent, side by side, and keeps them in the store: what it has is
/// not searched for again. `works` is 0 where nothing works. Those that a stop left out are
/// missing.
[[nodiscard]] std::vector<StabilityThreshold>
find_thresholds(std::vector<ThresholdSearch> searches, const std::string& case_name,
                const run::Settings& settings, store::Store& store, std::stop_token stop);

}  // namespace crossgrain::studies
