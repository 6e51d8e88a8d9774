#include "reports/documents/atomic_file.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

namespace crossgrain::reports {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail(std::error_code error, const fs::path& path, std::string_view action) {
    throw std::system_error(error, fmt::format("cannot {} '{}'", action, path.string()));
}

std::error_code last_error() {
    // Streams need not set errno; a failed write without it is an input/output error.
    return {errno != 0 ? errno : EIO, std::generic_category()};
}

/// The process that writes a temporary file "name.<pid>.tmp", or 0.
int writer_of(const fs::path& path) {
    if (path.extension() != ".tmp") return 0;
    const std::string number = path.stem().extension().string();
    int pid = 0;
    const auto [end, error] =
        std::from_chars(number.data() + std::min<std::size_t>(1, number.size()),
                        number.data() + number.size(), pid);
    return error == std::errc() && end == number.data() + number.size() ? pid : 0;
}

}  // namespace

void remove_unfinished_files(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> unfinished;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        const int pid = writer_of(entry.path());
        if (pid > 0 && ::kill(pid, 0) == -1 && errno == ESRCH) unfinished.push_back(entry.path());
    }
    // One that stays does no harm.
    for (const auto& path : unfinished)
        fs::remove(path, error);
}

void write_file_atomically(const fs::path& path, std::string_view text) {
    std::error_code error;
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
    if (error) fail(error, path.parent_path(), "create folder");

    // The process id keeps two programs that write the same report from sharing a temporary file.
    const fs::path temporary = path.string() + fmt::format(".{}.tmp", ::getpid());
    errno = 0;
    std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
    if (!out) fail(last_error(), path, "write");
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    out.close();
    if (!out) {
        const std::error_code cause = last_error();
        fs::remove(temporary, error);
        fail(cause, path, "write");
    }
    fs::rename(temporary, path, error);
    if (error) {
        const std::error_code cause = error;
        fs::remove(temporary, error);
        fail(cause, path, "replace");
    }
}

}  // namespace crossgrain::reports
