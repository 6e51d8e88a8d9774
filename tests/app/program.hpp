// Runs the built program as a user does, and keeps what it printed.
#pragma once

#include "adapters/process/log_file.hpp"
#include "adapters/process/process.hpp"
#include "tests/support/temporary_directory.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace crossgrain::tests {

struct Answer {
    int status = -1;
    std::string out, err;
    [[nodiscard]] bool says(const std::string& text) const {
        return out.find(text) != std::string::npos || err.find(text) != std::string::npos;
    }
    /// Lines of stderr that begin with "error:".
    [[nodiscard]] int error_lines() const {
        int count = 0;
        std::istringstream in(err);
        for (std::string line; std::getline(in, line);)
            count += line.starts_with("error:") ? 1 : 0;
        return count;
    }
};

class Program {
  public:
    /// Extra environment, e.g. "PATH=/nonexistent".
    std::vector<std::string> environment;

    /// Of another one, to share its results; empty: its own.
    std::filesystem::path shared_results;

    /// Put before the program, e.g. a shell that limits its memory.
    std::vector<std::string> launcher;

    [[nodiscard]] std::filesystem::path results() const {
        return shared_results.empty() ? directory_.path() / "results" : shared_results;
    }
    [[nodiscard]] const std::filesystem::path& directory() const { return directory_.path(); }

    Answer operator()(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), CROSSGRAIN_PROGRAM);
        arguments.insert(arguments.begin(), launcher.begin(), launcher.end());
        arguments.insert(arguments.end(), {"--results", results().string()});
        return answer_of(std::move(arguments));
    }

    /// A line of shell, in which `crossgrain ARGUMENTS` works on results().
    [[nodiscard]] Answer shell(const std::string& line) const {
        const std::string function =
            "crossgrain() { \"$PROGRAM\" --results \"$RESULTS\" \"$@\"; }; ";
        return answer_of({"/bin/sh", "-c", function + line});
    }

    /// Writes a copy of a test case with one text replaced; returns its path.
    [[nodiscard]] std::string case_with(const std::string& name, const std::string& from,
                                        const std::string& to) const {
        std::ifstream in(std::string(CROSSGRAIN_SOURCE_DIR "/tests/app/cases/") + name + ".toml");
        std::string text((std::istreambuf_iterator<char>(in)), {});
        const auto at = text.find(from);
        if (at == std::string::npos) throw std::logic_error("test case lacks: " + from);
        text.replace(at, from.size(), to);
        const auto path = directory_.path() / (name + ".toml");
        std::ofstream(path) << text;
        return path.string();
    }

  private:
    Answer answer_of(std::vector<std::string> argv) const {
        auto variables = environment;
        variables.push_back(std::string("PROGRAM=") + CROSSGRAIN_PROGRAM);
        variables.push_back("RESULTS=" + results().string());
        const auto result = adapters::process::run({.argv = std::move(argv),
                                                    .directory = directory_.path(),
                                                    .extra_environment = std::move(variables),
                                                    .time_limit = 120});
        const bool exited = result.ending == adapters::process::Ending::exited;
        return {.status = exited ? result.status : -1,
                .out = adapters::process::read_text(result.stdout_file, 50'000'000),
                .err = adapters::process::read_text(result.stderr_file, 50'000'000)};
    }

    TemporaryDirectory directory_;
};

}  // namespace crossgrain::tests
