// Which processes of a test are still there: those with a mark of it in their environment.
#pragma once

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include <sys/types.h>

namespace crossgrain::tests {

/// Numbers of the processes whose environment has the entry "NAME=value". Those that have ended
/// (zombies) have none.
inline std::vector<pid_t> processes_with(const std::string& entry) {
    std::vector<pid_t> found;
    std::error_code error;
    for (std::filesystem::directory_iterator item("/proc", error), end; !error && item != end;
         item.increment(error)) {
        const std::string name = item->path().filename().string();
        if (name.find_first_not_of("0123456789") != std::string::npos) continue;
        std::ifstream in("/proc/" + name + "/environ", std::ios::binary);
        const std::string text = '\0' + std::string(std::istreambuf_iterator<char>(in), {}) + '\0';
        if (text.find('\0' + entry + '\0') != std::string::npos) found.push_back(std::stoi(name));
    }
    return found;
}

/// Whether none of them is left, after waiting for at most `seconds`.
inline bool all_gone(const std::string& entry, double seconds = 5) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (!processes_with(entry).empty()) {
        if (std::chrono::steady_clock::now() > until) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return true;
}

}  // namespace crossgrain::tests
