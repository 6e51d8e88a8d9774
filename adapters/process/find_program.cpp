#include "adapters/process/find_program.hpp"

#include "adapters/process/log_file.hpp"
#include "adapters/process/process.hpp"

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

class TemporaryDirectory {
  public:
    TemporaryDirectory() {
        std::string name = (fs::temp_directory_path() / "crossgrain-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) {
            throw std::system_error(errno, std::generic_category(), name);
        }
        path_ = name;
    }
    ~TemporaryDirectory() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TemporaryDirectory(const TemporaryDirectory&) = delete;
    TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

    [[nodiscard]] const fs::path& path() const noexcept { return path_; }

  private:
    fs::path path_;
};

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

std::optional<std::string> output_of(const std::vector<std::string>& argv, double time_limit) {
    if (argv.empty() || !find_program(argv.front())) return std::nullopt;
    const TemporaryDirectory directory;
    Command command;
    command.argv = argv;
    command.directory = directory.path();
    command.time_limit = time_limit;
    try {
        const Result result = run(command);
        if (result.ending == Ending::time_limit) return std::nullopt;
        constexpr std::size_t limit = 1 << 20;
        return read_text(result.stdout_file, limit) + read_text(result.stderr_file, limit);
    } catch (const std::system_error&) {
        return std::nullopt;
    }
}

}  // namespace crossgrain::adapters::process
