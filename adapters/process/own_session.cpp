#include "adapters/process/own_session.hpp"

#include <csignal>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

namespace crossgrain::adapters::process {

namespace {

// The first descriptor that is not a standard one.
constexpr int first_other = STDERR_FILENO + 1;

void check(int error, const char* what) {
    if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

class FileActions {
  public:
    explicit FileActions(std::optional<int> inherited) {
        check(posix_spawn_file_actions_init(&actions_), "posix_spawn_file_actions_init");
        // Before the others, which may be where it is if our own standard files were closed.
        if (inherited) {
            check(posix_spawn_file_actions_adddup2(&actions_, *inherited, first_other), "dup2");
        }
        for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
            check(posix_spawn_file_actions_addopen(&actions_, standard, "/dev/null", O_RDWR, 0),
                  "open");
        // A file of ours that it holds open (say, another program's pipe) would outlive us.
        check(posix_spawn_file_actions_addclosefrom_np(&actions_,
                                                       inherited ? first_other + 1 : first_other),
              "closefrom");
    }
    ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
    FileActions(const FileActions&) = delete;
    FileActions& operator=(const FileActions&) = delete;

    [[nodiscard]] const posix_spawn_file_actions_t* get() const noexcept { return &actions_; }

  private:
    posix_spawn_file_actions_t actions_{};
};

class Attributes {
  public:
    explicit Attributes(bool block_signals) {
        check(posix_spawnattr_init(&attributes_), "posix_spawnattr_init");
        sigset_t all, none;
        sigfillset(&all);
        sigemptyset(&none);
        check(posix_spawnattr_setsigmask(&attributes_, block_signals ? &all : &none), "sigmask");
        check(posix_spawnattr_setsigdefault(&attributes_, &all), "sigdefault");
        check(posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGMASK |
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

}  // namespace

pid_t start_in_own_session(const SessionStart& start) {
    const FileActions actions(start.inherited);
    const Attributes attributes(start.block_signals);
    pid_t started = -1;
    check(posix_spawn(&started, start.program.c_str(), actions.get(), attributes.get(),
                      c_array(start.argv).data(), c_array(start.environment).data()),
          start.program.c_str());
    return started;
}

}  // namespace crossgrain::adapters::process
