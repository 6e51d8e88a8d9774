// Initial states that have to be made by a run: grains that settle in a plugged hopper before the
// plug is taken away. The native engine makes each state once; it is kept, by a digest of all that
// decides it, and handed to every code with the same 17 digits.
#pragma once

#include "adapters/code.hpp"
#include "adapters/run/settings.hpp"
#include "cases/scene/any_scene.hpp"

#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>

namespace crossgrain::run {

/// Makes states and keeps them as JSON in a directory, which threads and processes may share: who
/// needs a state that another is making waits for it.
class Preparations {
  public:
    /// `engine` makes the states, and must outlive this,
    /// as must the monitor; `version` is what it is known by.
    Preparations(std::filesystem::path directory, const adapters::GrainCode& engine,
                 std::string version, Monitor& monitor);

    /// The scene as a run starts from it (scene::start_of_run); one without a preparation as it is.
    /// Throws what the engine throws (AdapterError, Interrupted).
    [[nodiscard]] std::shared_ptr<const scene::AnyScene>
    prepared(std::shared_ptr<const scene::AnyScene> given, double time_limit,
             std::stop_token stop) const;

  private:
    [[nodiscard]] scene::InitialState settled(const scene::Scene& start, const std::string& key,
                                              double time_limit, std::stop_token stop) const;

    std::filesystem::path directory_;
    const adapters::GrainCode& engine_;
    std::string version_;
    Monitor* monitor_;
};

/// Those of the results' directory, made by the native engine.
[[nodiscard]] Preparations preparations_in(const Execution& settings);

}  // namespace crossgrain::run
