#include "adapters/process/guard_program.hpp"

#include "adapters/process/guard/protocol.hpp"

#include <csignal>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

namespace crossgrain::adapters::process {

namespace fs = std::filesystem;

namespace {

void check(int error, const char* what) {
    if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

/// Beside the executable, or (for tests) a directory above.
fs::path guard_path() {
    constexpr const char* name = "crossgrain-guard";
    std::error_code error;
    const fs::path own = fs::read_symlink("/proc/self/exe", error).parent_path();
    const fs::path beside = own / name;
    const fs::path above = own.parent_path() / name;
    return !fs::exists(beside, error) && fs::exists(above, error) ? above : beside;
}

class FileActions {
  public:
    explicit FileActions(int socket) {
        check(posix_spawn_file_actions_init(&actions_), "posix_spawn_file_actions_init");
        // Before the others, which may be where the socket is if ours were closed.
        check(posix_spawn_file_actions_adddup2(&actions_, socket, guard::socket_number), "dup2");
        for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
            check(posix_spawn_file_actions_addopen(&actions_, standard, "/dev/null", O_RDWR, 0),
                  "open");
        // A file of ours that the guard holds open (say, another program's pipe) would outlive us.
        check(posix_spawn_file_actions_addclosefrom_np(&actions_, guard::socket_number + 1),
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
    Attributes() {
        check(posix_spawnattr_init(&attributes_), "posix_spawnattr_init");
        sigset_t all;
        sigfillset(&all);
        check(posix_spawnattr_setsigmask(&attributes_, &all), "sigmask");
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

pid_t start_guard(int socket, std::vector<std::string> arguments,
                  const std::vector<std::string>& environment) {
    const fs::path path = guard_path();
    arguments.insert(arguments.begin(), path.filename().string());
    const FileActions actions(socket);
    const Attributes attributes;
    pid_t guard = -1;
    check(posix_spawn(&guard, path.c_str(), actions.get(), attributes.get(),
                      c_array(arguments).data(), c_array(environment).data()),
          path.c_str());
    return guard;
}

}  // namespace crossgrain::adapters::process
