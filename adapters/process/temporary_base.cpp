#include "adapters/process/temporary_base.hpp"

#include "native/base/errors.hpp"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

namespace crossgrain::adapters::process {

namespace fs = std::filesystem;

namespace {

/// As std::filesystem::temp_directory_path finds it, whether it is there or not.
fs::path temporary_directory() {
    for (const char* name : {"TMPDIR", "TMP", "TEMP", "TEMPDIR"}) {
        const char* value = std::getenv(name);
        if (value != nullptr && *value != '\0') return fs::absolute(value);
    }
    return "/tmp";
}

[[noreturn]] void refuse(const fs::path& path, const std::string& problem,
                         const std::string& hint) {
    throw CaseError({.file = path.string(),
                     .problem = problem,
                     .expected = "a directory for temporary files",
                     .hint = hint});
}

}  // namespace

fs::path temporary_base() {
    const char* const hint = "set TMPDIR to a directory that can be written";
    const fs::path parent = temporary_directory();
    std::error_code error;
    if (!fs::is_directory(parent, error)) refuse(parent, "is not a directory", hint);
    const fs::path base = parent / ("crossgrain-" + std::to_string(geteuid()));
    if (mkdir(base.c_str(), 0700) != 0 && errno != EEXIST) {
        refuse(base, "cannot be made: " + std::generic_category().message(errno), hint);
    }
    struct stat found {};
    const bool ours = lstat(base.c_str(), &found) == 0 && S_ISDIR(found.st_mode) &&
                      found.st_uid == geteuid() && (found.st_mode & (S_IRWXG | S_IRWXO)) == 0;
    if (!ours) {
        refuse(base, "is not a directory of this user alone (mode 0700)",
               "remove it, or set TMPDIR to a directory of your own");
    }
    if (access(base.c_str(), W_OK | X_OK) != 0) refuse(base, "cannot be written", hint);
    return base;
}

}  // namespace crossgrain::adapters::process
