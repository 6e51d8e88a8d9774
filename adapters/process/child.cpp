#include "adapters/process/child.hpp"

#include <cerrno>
#include <csignal>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace crossgrain::adapters::process {

namespace {

void check(int error, const char* what) {
    if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

class FileActions {
  public:
    explicit FileActions(const ChildSetup& setup) {
        check(posix_spawn_file_actions_init(&actions_), "posix_spawn_file_actions_init");
        constexpr int write_flags = O_WRONLY | O_CREAT | O_TRUNC;
        open_as(STDIN_FILENO, "/dev/null", O_RDONLY);
        open_as(STDOUT_FILENO, setup.stdout_file.c_str(), write_flags);
        open_as(STDERR_FILENO, setup.stderr_file.c_str(), write_flags);
        // A file of ours that the child holds open (say, another program's pipe) would outlive us.
        check(posix_spawn_file_actions_addclosefrom_np(&actions_, STDERR_FILENO + 1), "closefrom");
        check(posix_spawn_file_actions_addchdir_np(&actions_, setup.directory.c_str()), "chdir");
    }
    ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
    FileActions(const FileActions&) = delete;
    FileActions& operator=(const FileActions&) = delete;

    [[nodiscard]] const posix_spawn_file_actions_t* get() const noexcept { return &actions_; }

  private:
    void open_as(int descriptor, const char* path, int flags) {
        check(posix_spawn_file_actions_addopen(&actions_, descriptor, path, flags, 0644), path);
    }

    posix_spawn_file_actions_t actions_{};
};

class Attributes {
  public:
    Attributes() {
        check(posix_spawnattr_init(&attributes_), "posix_spawnattr_init");
        sigset_t none, all;
        sigemptyset(&none);
        sigfillset(&all);
        check(posix_spawnattr_setsigmask(&attributes_, &none), "sigmask");
        check(posix_spawnattr_setsigdefault(&attributes_, &all), "sigdefault");
        check(posix_spawnattr_setpgroup(&attributes_, 0), "pgroup");
        check(posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP |
                                                         POSIX_SPAWN_SETSIGMASK |
                                                         POSIX_SPAWN_SETSIGDEF),
              "posix_spawnattr_setflags");
    }
    ~Attributes() { posix_spawnattr_destroy(&attributes_); }
    Attributes(const Attributes&) = delete;
    Attributes& operator=(const Attributes&) = delete;

    [[nodiscard]] const posix_spawnattr_t* get() const noexcept { return &attributes_; }

  private:
    posix_spawnattr_t attributes_{};
};

/// The null-terminated array that exec wants; valid as long as `strings`.
std::vector<char*> c_array(const std::vector<std::string>& strings) {
    std::vector<char*> result;
    result.reserve(strings.size() + 1);
    // exec takes char* for historical reasons and does not write.
    for (const auto& text : strings)
        result.push_back(const_cast<char*>(text.c_str()));
    result.push_back(nullptr);
    return result;
}

double seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

Child::Child(const ChildSetup& setup) {
    const FileActions actions(setup);
    const Attributes attributes;
    const auto argv = c_array(setup.argv);
    const auto environment = c_array(setup.environment);
    check(posix_spawn(&pid_, setup.program.c_str(), actions.get(), attributes.get(), argv.data(),
                      environment.data()),
          setup.program.c_str());
}

Child::~Child() {
    if (pid_ < 0) return;
    signal_group(SIGKILL);
    while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

bool Child::has_ended() const {
    siginfo_t info{};
    while (waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) != 0) {
        if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waitid");
    }
    return info.si_pid == pid_;
}

void Child::signal_group(int signal_number) const noexcept {
    // Fails only when nobody is left, which is what is wanted.
    kill(-pid_, signal_number);
}

Reaped Child::reap() {
    signal_group(SIGKILL);
    int status = 0;
    rusage usage{};
    while (wait4(pid_, &status, 0, &usage) < 0) {
        if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "wait4");
    }
    pid_ = -1;
    const bool signalled = WIFSIGNALED(status);
    return {.signalled = signalled,
            .status = signalled ? WTERMSIG(status) : WEXITSTATUS(status),
            .cpu_s = seconds(usage.ru_utime) + seconds(usage.ru_stime)};
}

}  // namespace crossgrain::adapters::process
