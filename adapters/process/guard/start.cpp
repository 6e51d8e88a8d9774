#include "adapters/process/guard/start.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace crossgrain::adapters::process::guard {

namespace {

/// What a copy of the guard does on its way to becoming the program.
class Becoming {
  public:
    Becoming(const Order& order, pid_t guard, int failures)
        : order_(order), guard_(guard), failures_(failures) {}

    [[noreturn]] void operator()() const {
        require(prctl(PR_SET_PDEATHSIG, SIGKILL) == 0, Step::start);
        // A guard that ended before that line would never be missed.
        if (getppid() != guard_) _exit(127);
        require(setpgid(0, 0) == 0, Step::start);
        require(chdir(order_.directory) == 0, Step::enter_directory);
        open_as(STDIN_FILENO, "/dev/null", O_RDONLY, Step::start);
        constexpr int write_flags = O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW;
        open_as(STDOUT_FILENO, order_.stdout_file, write_flags, Step::open_stdout);
        open_as(STDERR_FILENO, order_.stderr_file, write_flags, Step::open_stderr);
        limit(RLIMIT_CORE, 0);
        limit(RLIMIT_FSIZE, order_.largest_file);
        sigset_t none;
        sigemptyset(&none);
        require(sigprocmask(SIG_SETMASK, &none, nullptr) == 0, Step::start);
        execv(order_.program, order_.argv);
        fail(Step::execute);
    }

  private:
    [[noreturn]] void fail(Step step) const {
        const StartFailure failure{.step = step, .error = errno};
        // Smaller than a pipe's buffer: written whole.
        (void)!write(failures_, &failure, sizeof failure);
        _exit(127);
    }
    void require(bool done, Step step) const {
        if (!done) fail(step);
    }
    void open_as(int descriptor, const char* path, int flags, Step step) const {
        const int file = open(path, flags | O_CLOEXEC, 0644);
        require(file >= 0 && dup2(file, descriptor) == descriptor, step);
    }
    void limit(__rlimit_resource resource, rlim_t value) const {
        rlimit bounds{};
        require(getrlimit(resource, &bounds) == 0, Step::start);
        bounds.rlim_max = std::min(bounds.rlim_max, value);
        bounds.rlim_cur = std::min(bounds.rlim_cur, value);
        require(setrlimit(resource, &bounds) == 0, Step::start);
    }

    const Order& order_;
    pid_t guard_;
    int failures_;
};

}  // namespace

std::variant<pid_t, StartFailure> start(const Order& order) {
    const auto failed = [] { return StartFailure{.step = Step::start, .error = errno}; };
    int failures[2];  // closed by a successful exec
    if (pipe2(failures, O_CLOEXEC) != 0) return failed();
    const pid_t guard = getpid();
    const pid_t program = fork();
    if (program < 0) return failed();
    if (program == 0) Becoming(order, guard, failures[1])();
    close(failures[1]);
    StartFailure failure;
    ssize_t got = 0;
    while ((got = read(failures[0], &failure, sizeof failure)) < 0 && errno == EINTR) {
    }
    close(failures[0]);
    if (got != sizeof failure) return program;
    waitpid(program, nullptr, 0);
    return failure;
}

}  // namespace crossgrain::adapters::process::guard
