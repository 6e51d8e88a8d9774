#include "adapters/process/find_program.hpp"

#include <cstdlib>
#include <sstream>
#include <system_error>

#include <unistd.h>

namespace crossgrain::adapters::process {

namespace fs = std::filesystem;

namespace {

bool is_executable(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored) && access(path.c_str(), X_OK) == 0;
}

}  // namespace

std::optional<fs::path> find_program(const std::string& name) {
    if (name.find('/') != std::string::npos) {
        if (is_executable(name)) return fs::absolute(name);
        return std::nullopt;
    }
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        // An empty entry means the working directory.
        const fs::path candidate = fs::path(folder.empty() ? "." : folder) / name;
        if (is_executable(candidate)) return fs::absolute(candidate);
    }
    return std::nullopt;
}

}  // namespace crossgrain::adapters::process
