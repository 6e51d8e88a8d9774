#include "adapters/yade/left_folders.hpp"

#include <ctime>
#include <exception>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

namespace crossgrain::adapters::yade {

namespace fs = std::filesystem;

namespace {

bool is_ours(const fs::path& path, struct stat& found) {
    return lstat(path.c_str(), &found) == 0 && found.st_uid == geteuid();
}

/// Whether a process of this user runs a program called yade...
bool runs_now() {
    std::error_code error;
    for (fs::directory_iterator entry("/proc", error), end; !error && entry != end;
         entry.increment(error)) {
        struct stat found {};
        const std::string name = entry->path().filename().string();
        if (name.find_first_not_of("0123456789") != std::string::npos) continue;
        if (std::stol(name) == getpid() || !is_ours(entry->path(), found)) continue;
        std::ifstream in(entry->path() / "cmdline", std::ios::binary);
        const std::string command(std::istreambuf_iterator<char>(in), {});
        if (command.find("/yade") != std::string::npos) return true;
    }
    return static_cast<bool>(error);  // not known
}

bool has_name(const std::string& name) {
    constexpr std::string_view stem = "yade-";
    constexpr std::size_t random_characters = 6;
    return name.starts_with(stem) && name.size() == stem.size() + random_characters;
}

}  // namespace

void remove_old_folders(const fs::path& parent) noexcept {
    try {
        constexpr std::time_t youngest = 10;
        const std::time_t now = std::time(nullptr);
        std::error_code error;
        for (fs::directory_iterator entry(parent, error), end; !error && entry != end;
             entry.increment(error)) {
            struct stat found {};
            if (!has_name(entry->path().filename().string())) continue;
            if (!is_ours(entry->path(), found) || !S_ISDIR(found.st_mode)) continue;
            // Only an empty one goes.
            if (now - found.st_mtime >= youngest) rmdir(entry->path().c_str());
        }
    } catch (const std::exception&) {
        // Out of memory: the next call removes them.
    }
}

void sweep_folders() noexcept {
    try {
        if (!runs_now()) remove_old_folders(folder_parent);
    } catch (const std::exception&) {
        // As above.
    }
}

}  // namespace crossgrain::adapters::yade
