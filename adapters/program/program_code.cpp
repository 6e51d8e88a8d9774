#include "adapters/program/program_code.hpp"

#include "adapters/process/find_program.hpp"
#include "adapters/process/log_file.hpp"
#include "adapters/process/process.hpp"
#include "adapters/process/program_identity.hpp"
#include "adapters/process/question.hpp"
#include "adapters/program/answer_judge.hpp"
#include "adapters/program/trajectory_stream.hpp"
#include "native/base/errors.hpp"
#include "native/base/printable.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cerrno>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

namespace crossgrain::adapters {

namespace fs = std::filesystem;

namespace {

std::string read_log(const fs::path& file) {
    constexpr std::size_t limit = std::size_t{4} << 20;  // errors stand at the end
    return process::read_text(file, limit);
}

std::string log_tail(const fs::path& directory) {
    constexpr std::size_t lines = 20;
    const std::string out = process::tail(directory / "stdout.txt", lines);
    const std::string err = process::tail(directory / "stderr.txt", lines);
    return out.empty() || err.empty() ? out + err : out + "\n" + err;
}

void write_file(const fs::path& path, const std::string& text) {
    errno = 0;
    std::ofstream out(path, std::ios::binary);
    out << text;
    if (!out.flush())
        throw std::system_error(errno != 0 ? errno : EIO, std::generic_category(),
                                fmt::format("cannot write '{}'", path.string()));
}

std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

/// The error that a failed run becomes, with all that can be known about it.
class FailureReport {
  public:
    FailureReport(std::string code, const std::vector<std::string>& argv, fs::path directory)
        : code_(std::move(code)), command_(fmt::format("{}", fmt::join(argv, " "))),
          directory_(std::move(directory)) {}

    [[nodiscard]] AdapterError operator()(const std::string& reason, const std::string& exit,
                                          bool timed_out = false) const {
        return AdapterError({.code = code_,
                             .reason = first_line(reason),
                             .command = command_,
                             .exit = exit,
                             .log_tail = log_tail(directory_),
                             .directory = directory_.string(),
                             .timed_out = timed_out});
    }

  private:
    std::string code_, command_;
    fs::path directory_;
};

/// Runs the program to whatever end. A trajectory that is none ends it and becomes an AdapterError;
/// whatever else the sink throws ends it and is rethrown.
process::Result execute(const process::Command& command, const TrajectoryStream& trajectory,
                        const FailureReport& failure) {
    try {
        return process::run(command);
    } catch (const TrajectoryError& error) {
        throw failure(error.what(), "ended because of its trajectory");
    } catch (const std::system_error& error) {
        // The sink's own troubles are not the program's.
        if (trajectory.has_failed()) throw;
        throw failure(error.what(), "not started");
    }
}

/// Throws unless the program ended well and its trajectory is complete. Its own words
/// (`error_text`) say more than how it exited, and that says more than what is missing.
void judge(const process::Result& result, const std::optional<std::string>& error_text,
           double time_limit, TrajectoryStream& trajectory, const FailureReport& failure) {
    if (result.ending == process::Ending::stopped) throw Interrupted();
    const std::string exit = process::describe(result, time_limit);
    if (result.ending == process::Ending::time_limit) {
        throw failure(fmt::format("not finished within {:g} s ({} frames so far)", time_limit,
                                  trajectory.frames()),
                      exit, true);
    }
    if (result.ending == process::Ending::too_much_output) throw failure(exit, exit);
    if (error_text) throw failure(*error_text, exit);
    if (result.ending == process::Ending::signalled || result.status != 0) {
        throw failure(exit + ", without an error message", exit);
    }
    try {
        trajectory.finish();
    } catch (const TrajectoryError& error) {
        throw failure(error.what(), exit);
    }
}

constexpr double longest_question_s = 30;

Availability unusable(const std::string& reason) {
    constexpr std::size_t longest = 1000;
    return {.reason = printable(reason, longest)};
}

}  // namespace

ProgramCode::ProgramCode(std::string program) : program_(std::move(program)) {}

std::vector<std::string> ProgramCode::command_line(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), program_);
    return arguments;
}

std::optional<std::string> ProgramCode::why_missing() const {
    if (process::find_program(program_)) return std::nullopt;
    return fmt::format("no '{}' on PATH", program_);
}

Availability ProgramCode::probe(std::stop_token stop) const {
    const std::scoped_lock lock(mutex_);
    if (!availability_) availability_ = ask(std::move(stop));
    return *availability_;
}

Availability ProgramCode::ask(std::stop_token stop) const {
    if (auto reason = why_missing()) return {.reason = std::move(*reason)};
    const process::Question question{.argv = command_line(version_arguments()),
                                     .extra_environment = environment(),
                                     .time_limit = longest_question_s,
                                     .stop = stop};
    const std::string command = fmt::format("'{}'", fmt::join(question.argv, " "));
    try {
        const process::Answer answer = process::ask(question);
        if (answer.ending == process::Ending::stopped) throw Interrupted();
        if (const auto reason = why_no_answer(answer)) {
            return unusable(fmt::format("{} {}", command, *reason));
        }
        Availability found = availability_from(answer.out + answer.err);
        if (!found.installed) return unusable(found.reason + last_words(answer));
        found.version = printable(found.version);
        identify(found, stop);
        return found;
    } catch (const std::system_error& error) {
        return unusable(fmt::format("{} does not run: {}", command, error.what()));
    }
}

void ProgramCode::identify(Availability& found, const std::stop_token& stop) const {
    const fs::path executable = fs::canonical(process::find_program(program_).value());
    const auto identity = process::identify({.program = executable,
                                             .further_files = further_files(executable),
                                             .extra_environment = environment()},
                                            stop);
    found.program = identity.program.string();
    found.digest = identity.digest;
}

RunCost ProgramCode::run(const scene::Scene& scene, const RunOptions& options,
                         const scene::FrameSink& sink) const {
    const std::vector<std::string> argv = command_line(run_arguments());
    const FailureReport failure(name(), argv, options.directory);
    if (const auto reason = cannot_express(scene)) {
        throw failure("cannot express this scene: " + *reason, "not started");
    }
    if (const auto reason = why_missing()) throw failure(*reason, "not started");
    for (const auto& file : options.input.empty() ? input(scene) : options.input)
        write_file(options.directory / file.name, file.text);
    TrajectoryStream trajectory(
        scene, sink, options.keep_dump ? options.directory / kept_dump_name : fs::path());
    const process::Command command{
        .argv = argv,
        .directory = options.directory,
        .extra_environment = environment(),
        .time_limit = options.time_limit,
        .stop = options.stop,
        .stream_name = dump_name,
        .on_stream = [&](std::string_view bytes) { trajectory.take(bytes); }};
    const process::Result result = execute(command, trajectory, failure);
    judge(result, error_in(read_log(result.stdout_file), read_log(result.stderr_file)),
          options.time_limit, trajectory, failure);
    return {.cpu_s = result.cpu_s, .wall_s = result.wall_s};
}

}  // namespace crossgrain::adapters
