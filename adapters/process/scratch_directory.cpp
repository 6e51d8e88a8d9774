#include "adapters/process/scratch_directory.hpp"

#include <cerrno>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace crossgrain::adapters::process {

namespace fs = std::filesystem;

namespace {

constexpr const char* mark_name = "running";

/// The locked mark of a directory, new or left by another; nothing if it is held by somebody (or,
/// without `create`, is not there).
std::optional<int> locked_mark(const fs::path& directory, bool create) {
    const fs::path mark = directory / mark_name;
    const int flags = O_RDWR | O_CLOEXEC | O_NOFOLLOW | (create ? O_CREAT | O_EXCL : 0);
    const int file = open(mark.c_str(), flags, 0600);
    // Without the directory a sweep was faster.
    if (file < 0 && create && errno != ENOENT) {
        const std::error_code cause(errno, std::generic_category());
        rmdir(directory.c_str());
        throw fs::filesystem_error("cannot mark a directory as in use", mark, cause);
    }
    if (file < 0) return std::nullopt;
    // Its holder may have removed it since: then the directory of that name is a new one.
    struct stat found {};
    if (flock(file, LOCK_EX | LOCK_NB) == 0 && fstat(file, &found) == 0 && found.st_nlink > 0)
        return file;
    close(file);
    return std::nullopt;
}

/// Whether `name` is that of a scratch directory with this stem: <stem>-<digits>[-<digits>].
bool has_stem(std::string_view name, std::string_view stem) {
    if (!name.starts_with(stem) || name.size() < stem.size() + 2 || name[stem.size()] != '-')
        return false;
    return name.find_first_not_of("0123456789-", stem.size()) == std::string_view::npos;
}

bool ends_in_number(std::string_view name) {
    const std::size_t last = name.find_last_not_of("0123456789");
    return last != std::string_view::npos && last + 1 < name.size() && name[last] == '-';
}

std::vector<fs::path> directories_in(const fs::path& parent) {
    std::vector<fs::path> found;
    std::error_code error;
    for (fs::directory_iterator entry(parent, error), end; !error && entry != end;
         entry.increment(error)) {
        if (entry->is_directory(error) && !entry->is_symlink(error)) found.push_back(entry->path());
    }
    return found;
}

/// The mark goes last: who is killed in between leaves what the next sweep takes.
void remove_marked(const fs::path& directory) {
    std::error_code ignored;
    for (fs::directory_iterator entry(directory, ignored), end; !ignored && entry != end;) {
        const fs::path path = entry->path();
        entry.increment(ignored);
        std::error_code left;
        if (path.filename() != mark_name) fs::remove_all(path, left);
    }
    fs::remove_all(directory, ignored);
}

}  // namespace

ScratchDirectory::ScratchDirectory(const fs::path& parent, const std::string& stem)
    : parent_(fs::absolute(parent)), stem_(stem) {
    fs::create_directories(parent_);
    const std::string name = stem + "-" + std::to_string(getpid());
    constexpr int attempts = 10'000;
    for (int attempt = 1; attempt <= attempts; ++attempt) {
        path_ = parent_ / (attempt == 1 ? name : name + "-" + std::to_string(attempt));
        if (mkdir(path_.c_str(), 0777) != 0) {
            if (errno == EEXIST) continue;
            throw fs::filesystem_error("cannot make a directory for a run", path_,
                                       std::error_code(errno, std::generic_category()));
        }
        // A sweep that comes between these two lines takes the directory for an empty left-over.
        if (const auto mark = locked_mark(path_, true)) {
            lock_ = *mark;
            return;
        }
    }
    throw fs::filesystem_error("no directory of its own can be made for a run", path_,
                               std::make_error_code(std::errc::file_exists));
}

ScratchDirectory::~ScratchDirectory() {
    if (lock_ < 0) return;
    remove_marked(path_);
    close(lock_);
}

void ScratchDirectory::keep() noexcept {
    try {
        for (const auto& other : directories_in(parent_)) {
            std::error_code ignored;
            if (other == path_ || !has_stem(other.filename().string(), stem_)) continue;
            if (!fs::exists(other / mark_name, ignored)) fs::remove_all(other, ignored);
        }
    } catch (const std::exception&) {
        // Out of memory: an older directory too many does no harm.
    }
    std::error_code ignored;
    fs::remove(path_ / mark_name, ignored);
    close(lock_);
    lock_ = -1;
}

void sweep(const fs::path& parent) noexcept {
    try {
        for (const auto& directory : directories_in(parent)) {
            // Empty: its maker died before it was marked.
            if (ends_in_number(directory.filename().string())) rmdir(directory.c_str());
            const auto mark = locked_mark(directory, false);
            if (!mark) continue;
            remove_marked(directory);
            close(*mark);
        }
    } catch (const std::exception&) {
        // Out of memory: the next call sweeps.
    }
}

}  // namespace crossgrain::adapters::process
