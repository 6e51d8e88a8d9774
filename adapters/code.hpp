// The one interface behind which every code stands, native engine or foreign program.
#pragma once

#include "cases/scene/any_scene.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace crossgrain::adapters {

/// Whether the code is on this machine.
struct Availability {
    bool installed = false;
    std::string version;  ///< as the program itself reports it
    std::string reason;   ///< why it is not installed, e.g. "no 'lmp' on PATH"
    std::string program;  ///< path of the executable, links followed; empty for our own engines
    /// SHA-256 over the executable and all that it loads; empty for our own engines, which the
    /// digest of the sources stands for.
    std::string digest;
};

/// One file of a code's input, by its name in the run's directory.
struct InputFile {
    std::string name;
    std::string text;
};

/// A kept trajectory of grains, in the run's directory: a LAMMPS text dump, compressed with zstd.
inline constexpr const char* kept_dump_name = "dump.txt.zst";

struct RunOptions {
    std::filesystem::path directory;  ///< private to this run; exists and is empty
    double time_limit = 0;            ///< wall seconds; the run is stopped when they are over, > 0
    std::stop_token stop;             ///< the user asked to stop
    bool keep_dump = false;           ///< also write the trajectory into the directory
    /// What a program is started with instead of `input(scene)`, e.g. edited by hand; empty: that.
    std::vector<InputFile> input = {};
};

struct RunCost {
    double cpu_s = 0;  ///< user + system, all processes and threads of the run
    double wall_s = 0;
};

class Code {
  public:
    virtual ~Code() = default;

    [[nodiscard]] virtual std::string name() const = 0;
    /// Throws Interrupted on a stop request.
    [[nodiscard]] virtual Availability probe(std::stop_token stop = {}) const = 0;
    /// What it can express, in the scene's own words, for `crossgrain codes`.
    [[nodiscard]] virtual std::vector<std::string> features() const = 0;
};

/// A code that runs one kind of scene: `scene::Scene`, `scene::LatticeGas`, ...
template <class SceneT>
class CodeFor : public Code {
  public:
    using Frame = typename scene::FrameOf<SceneT>::type;
    using Sink = std::function<void(const Frame&)>;

    /// Why it cannot run this scene exactly, or nothing if it can. Never approximates.
    [[nodiscard]] virtual std::optional<std::string> cannot_express(const SceneT& scene) const = 0;
    /// The complete input, file by file, a pure function of the scene.
    [[nodiscard]] virtual std::vector<InputFile> input(const SceneT& scene) const = 0;
    /// Runs the scene and streams its frames (those of grains checked by a FrameGuard).
    /// Throws AdapterError when the run does not deliver, Interrupted when stopped.
    virtual RunCost run(const SceneT& scene, const RunOptions& options, const Sink& sink) const = 0;
};

using GrainCode = CodeFor<scene::Scene>;
using GasCode = CodeFor<scene::LatticeGas>;
using SignalCode = CodeFor<scene::SyntheticSignal>;
using HopperCode = CodeFor<scene::HopperAutomaton>;

}  // namespace crossgrain::adapters
