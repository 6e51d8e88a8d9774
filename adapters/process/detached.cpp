#include "adapters/process/detached.hpp"

#include "adapters/process/own_session.hpp"

#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

#include <sys/wait.h>
#include <unistd.h>

namespace crossgrain::adapters::process {

bool start_detached(const std::filesystem::path& program, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), program.filename().string());
    std::vector<std::string> environment;
    for (char** entry = environ; *entry != nullptr; ++entry)
        environment.emplace_back(*entry);
    try {
        const pid_t started = start_in_own_session({.program = program,
                                                    .argv = std::move(arguments),
                                                    .environment = std::move(environment)});
        constexpr auto turn = std::chrono::milliseconds(20);
        for (int turns = 100; turns > 0; --turns) {
            int status = 0;
            if (waitpid(started, &status, WNOHANG) == started) return status == 0;
            std::this_thread::sleep_for(turn);
        }
        return true;
    } catch (const std::system_error&) {
        return false;
    }
}

}  // namespace crossgrain::adapters::process
