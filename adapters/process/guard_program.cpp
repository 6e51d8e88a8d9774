#include "adapters/process/guard_program.hpp"

#include "adapters/process/guard/protocol.hpp"
#include "adapters/process/own_session.hpp"

#include <filesystem>
#include <system_error>

namespace crossgrain::adapters::process {

namespace fs = std::filesystem;

namespace {

/// Beside the executable, or (for tests) a directory above.
fs::path guard_path() {
    constexpr const char* name = "crossgrain-guard";
    std::error_code error;
    const fs::path own = fs::read_symlink("/proc/self/exe", error).parent_path();
    const fs::path beside = own / name;
    const fs::path above = own.parent_path() / name;
    return !fs::exists(beside, error) && fs::exists(above, error) ? above : beside;
}

}  // namespace

pid_t start_guard(int socket, std::vector<std::string> arguments,
                  const std::vector<std::string>& environment) {
    static_assert(guard::socket_number == 3, "as start_in_own_session hands it over");
    const fs::path path = guard_path();
    arguments.insert(arguments.begin(), path.filename().string());
    return start_in_own_session({.program = path,
                                 .argv = std::move(arguments),
                                 .environment = environment,
                                 .inherited = socket,
                                 .block_signals = true});
}

}  // namespace crossgrain::adapters::process
