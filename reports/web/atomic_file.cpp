#include "reports/web/atomic_file.hpp"

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

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

}  // namespace

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
