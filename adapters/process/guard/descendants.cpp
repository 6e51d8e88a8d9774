#include "adapters/process/guard/descendants.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace crossgrain::adapters::process::guard {

namespace {

/// The parent of a process; 0 if it is gone. Its name, in parentheses, may hold anything.
pid_t parent_of(const std::string& number) {
    std::ifstream in("/proc/" + number + "/stat");
    std::string text;
    std::getline(in, text, '\0');
    const std::size_t name_end = text.rfind(')');
    constexpr std::size_t state = 4;  // ") S "
    if (name_end == std::string::npos || name_end + state >= text.size()) return 0;
    return static_cast<pid_t>(std::strtol(text.c_str() + name_end + state, nullptr, 10));
}

/// From /proc, because only some kernels list the children of a process.
std::vector<pid_t> children() {
    std::vector<pid_t> found;
    std::error_code error;
    for (std::filesystem::directory_iterator entry("/proc", error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name.find_first_not_of("0123456789") != std::string::npos) continue;
        if (parent_of(name) == getpid()) found.push_back(std::stoi(name));
    }
    return found;
}

}  // namespace

void Descendants::signal_group(int signal_number) const noexcept {
    // Once the leader is reaped, its number may be somebody else's.
    if (!status_) kill(-leader_, signal_number);
}

bool Descendants::reap_others() {
    while (true) {
        siginfo_t ended{};
        if (waitid(P_ALL, 0, &ended, WEXITED | WNOHANG | WNOWAIT) != 0) {
            if (errno == EINTR) continue;
            return errno == ECHILD;
        }
        if (ended.si_pid == 0) return false;
        if (ended.si_pid == leader_) return true;
        waitpid(ended.si_pid, nullptr, 0);
    }
}

void Descendants::kill_all() const {
    signal_group(SIGKILL);
    for (const pid_t child : children()) {
        // Its group goes at once, so that it cannot fork faster than we look.
        const pid_t group = getpgid(child);
        if (group > 0 && group != getpgrp()) kill(-group, SIGKILL);
        kill(child, SIGKILL);
    }
}

/// Whether somebody is left.
bool Descendants::reap_all() {
    while (true) {
        int status = 0;
        const pid_t ended = waitpid(-1, &status, WNOHANG);
        if (ended == 0) return true;
        if (ended == leader_) status_ = status;
        if (ended < 0 && errno != EINTR) return false;
    }
}

void Descendants::end(std::chrono::milliseconds patience) {
    const auto until = std::chrono::steady_clock::now() + patience;
    auto pause = std::chrono::microseconds(100);
    constexpr auto longest_pause = std::chrono::microseconds(20'000);
    for (kill_all(); reap_all() && std::chrono::steady_clock::now() < until; kill_all()) {
        std::this_thread::sleep_for(pause);
        pause = std::min(2 * pause, longest_pause);
    }
}

}  // namespace crossgrain::adapters::process::guard
