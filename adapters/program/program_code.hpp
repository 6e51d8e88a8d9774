// A code that is a program: ask it what it is, write its input into a private directory, start it,
// read its dump from a pipe while it runs, and judge how it ended. What differs from program to
// program (its input, its arguments, how it reports version and errors) is all that an adapter has
// to say.
#pragma once

#include "adapters/code.hpp"

#include <filesystem>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace crossgrain::adapters {

class ProgramCode : public GrainCode {
  public:
    /// Name of the pipe (in the run's directory) to which the input must direct the dump.
    static constexpr const char* dump_name = "trajectory.dump";

    /// `program`: name on PATH or path of the executable.
    explicit ProgramCode(std::string program);

    /// Asks the program once per object. Throws Interrupted on a stop request, CaseError if there
    /// is no directory for temporary files.
    [[nodiscard]] Availability probe(std::stop_token stop = {}) const final;
    RunCost run(const scene::Scene& scene, const RunOptions& options,
                const scene::FrameSink& sink) const final;

  protected:
    [[nodiscard]] const std::string& program() const noexcept { return program_; }

    /// With these arguments the program says what it is and ends, e.g. {"--version"}.
    [[nodiscard]] virtual std::vector<std::string> version_arguments() const = 0;
    /// What that answer means: installed in this version, or of no use for this reason, e.g.
    /// because it names no version.
    [[nodiscard]] virtual Availability availability_from(const std::string& answer) const = 0;
    /// What decides its results besides the executable and the libraries that this loads: modules
    /// of a script, plug-ins. `executable`: absolute, links followed.
    [[nodiscard]] virtual std::vector<std::filesystem::path>
    further_files(const std::filesystem::path& executable) const {
        (void)executable;
        return {};
    }
    /// Arguments of a run, which takes place in the directory that holds `input(scene)`.
    [[nodiscard]] virtual std::vector<std::string> run_arguments() const = 0;
    [[nodiscard]] virtual std::vector<std::string> environment() const { return {}; }
    /// The first error message in the program's output although it may have exited with 0, e.g.
    /// the line that starts with "ERROR"; nothing if there is none. Of a huge output only the last
    /// 4 MB are given.
    [[nodiscard]] virtual std::optional<std::string>
    error_in(const std::string& stdout_text, const std::string& stderr_text) const = 0;

  private:
    /// The program, then its arguments.
    [[nodiscard]] std::vector<std::string> command_line(std::vector<std::string> arguments) const;
    [[nodiscard]] std::optional<std::string> why_missing() const;
    [[nodiscard]] Availability ask(std::stop_token stop) const;
    void identify(Availability& found, const std::stop_token& stop) const;

    std::string program_;
    mutable std::mutex mutex_;
    mutable std::optional<Availability> availability_;
};

}  // namespace crossgrain::adapters
