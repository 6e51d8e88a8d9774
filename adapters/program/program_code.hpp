// A code that is a program: write its input into a private directory, start it, read its dump from
// a pipe while it runs, and judge how it ended. What differs from program to program (its input,
// its command line, how it reports errors) is all that an adapter has to say.
#pragma once

#include "adapters/code.hpp"

#include <optional>
#include <string>
#include <vector>

namespace crossgrain::adapters {

class ProgramCode : public Code {
  public:
    /// Name of the pipe (in the run's directory) to which the input must direct the dump.
    static constexpr const char* dump_name = "trajectory.dump";

    RunCost run(const scene::Scene& scene, const RunOptions& options,
                const scene::FrameSink& sink) const final;

  protected:
    /// Command line, argv[0] on PATH; run in the directory that holds `input(scene)`.
    [[nodiscard]] virtual std::vector<std::string> command_line() const = 0;
    [[nodiscard]] virtual std::vector<std::string> environment() const { return {}; }
    /// The first error message in the program's output although it may have exited with 0, e.g.
    /// the line that starts with "ERROR"; nothing if there is none. Of a huge output only the last
    /// 4 MB are given.
    [[nodiscard]] virtual std::optional<std::string>
    error_in(const std::string& stdout_text, const std::string& stderr_text) const = 0;
};

}  // namespace crossgrain::adapters
