// A call of the program that is sent a signal at some moment, and what it leaves behind.
#pragma once

#include "tests/support/processes.hpp"
#include "tests/support/temporary_directory.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace crossgrain::tests {

/// How a call ended.
struct CallEnd {
    bool ended = false;  ///< by itself, within the time it was given
    int status = -1;     ///< exit status
    int signal = 0;      ///< that killed it
    double seconds = 0;  ///< from its start, or from the signal, to its end
};

/// The results directory and the directory for temporary files of some calls, and a mark in the
/// environment that all their descendants inherit.
class CallSite {
  public:
    [[nodiscard]] std::filesystem::path results() const { return directory_.path() / "results"; }
    [[nodiscard]] const std::filesystem::path& directory() const { return directory_.path(); }

    /// Starts the program; standard output and error are thrown away.
    void start(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), CROSSGRAIN_PROGRAM);
        arguments.insert(arguments.end(), {"--results", results().string()});
        std::filesystem::create_directories(temporary());
        start_ = std::chrono::steady_clock::now();
        child_ = fork();
        if (child_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
        if (child_ == 0) become(arguments);
    }
    void send(int signal) {
        start_ = std::chrono::steady_clock::now();
        kill(child_, signal);
    }
    /// Waits; kills it when the time is over.
    CallEnd wait(double seconds) {
        CallEnd end;
        int status = 0;
        pid_t got = 0;
        while ((got = waitpid(child_, &status, WNOHANG)) == 0 && elapsed() < seconds)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        end.ended = got == child_;
        end.seconds = elapsed();
        if (!end.ended) {
            kill(child_, SIGKILL);
            waitpid(child_, &status, 0);
        }
        if (WIFEXITED(status)) end.status = WEXITSTATUS(status);
        if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
        return end;
    }
    [[nodiscard]] bool nobody_left() const { return all_gone(mark_); }

    /// Directories of runs and of questions that nobody holds any more.
    [[nodiscard]] std::vector<std::string> left_directories() const {
        std::vector<std::string> found;
        for (const auto& place : {results() / "runs", results() / "prepared", temporary()}) {
            std::error_code error;
            const bool temporaries = place == temporary();
            for (const auto& entry : std::filesystem::directory_iterator(place, error)) {
                if (!entry.is_directory()) continue;
                if (!temporaries) found.push_back(entry.path().string());
                for (const auto& below : std::filesystem::directory_iterator(entry.path())) {
                    if (temporaries) found.push_back(below.path().string());
                }
            }
        }
        return found;
    }

  private:
    [[nodiscard]] std::filesystem::path temporary() const { return directory_.path() / "tmp"; }
    [[nodiscard]] double elapsed() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }
    [[noreturn]] void become(std::vector<std::string>& arguments) const {
        putenv(const_cast<char*>(mark_.c_str()));
        setenv("TMPDIR", temporary().c_str(), 1);
        const int nowhere = open("/dev/null", O_RDWR);
        for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
            dup2(nowhere, standard);
        std::vector<char*> argv;
        for (auto& argument : arguments)
            argv.push_back(argument.data());
        argv.push_back(nullptr);
        for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE})
            std::signal(signal, SIG_DFL);
        execv(argv[0], argv.data());
        _exit(127);
    }

    TemporaryDirectory directory_;
    std::string mark_ = "CROSSGRAIN_FAULT_MARK=" + directory_.path().string();
    std::chrono::steady_clock::time_point start_;
    pid_t child_ = -1;
};

/// What the store holds: the measurements of each key, as text; how often it was computed.
struct Stored {
    std::string integrity = "ok";
    std::map<std::string, std::string> measurements;
    std::map<std::string, int> times;
};

inline Stored stored_in(const std::filesystem::path& results) {
    Stored stored;
    if (!std::filesystem::exists(results / "crossgrain.db")) return stored;
    SQLite::Database database(results / "crossgrain.db", SQLite::OPEN_READWRITE);
    stored.integrity = database.execAndGet("PRAGMA integrity_check").getString();
    // Killed before it had made its tables.
    if (!database.tableExists("run")) return stored;
    SQLite::Statement runs(database, "SELECT key FROM run WHERE status = 'ok'");
    while (runs.executeStep())
        ++stored.times[runs.getColumn(0).getString()];
    SQLite::Statement rows(database,
                           "SELECT key, observable, printf('%!.17g %!.17g %!.17g', value, stderr, "
                           "systematic), n FROM run JOIN measurement ON run.id = run_id "
                           "WHERE status = 'ok' ORDER BY key, run.id, observable");
    while (rows.executeStep()) {
        stored.measurements[rows.getColumn(0).getString()] += rows.getColumn(1).getString() + ' ' +
                                                              rows.getColumn(2).getString() + ' ' +
                                                              rows.getColumn(3).getString() + '\n';
    }
    return stored;
}

}  // namespace crossgrain::tests
