#include "adapters/process/file_digests.hpp"

#include "native/base/digest.hpp"
#include "native/base/errors.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace crossgrain::adapters::process {

namespace fs = std::filesystem;

namespace {

/// A file that is open for reading.
class OpenFile {
  public:
    explicit OpenFile(const fs::path& path)
        : path_(path), file_(open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
        if (file_ < 0) fail();
    }
    ~OpenFile() { close(file_); }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    [[nodiscard]] struct stat state() const {
        struct stat found {};
        if (fstat(file_, &found) != 0) fail();
        return found;
    }
    /// False at its end.
    bool read(std::vector<char>& buffer, std::size_t& size) const {
        ssize_t got = 0;
        while ((got = ::read(file_, buffer.data(), buffer.size())) < 0) {
            if (errno != EINTR) fail();
        }
        size = static_cast<std::size_t>(got);
        return got > 0;
    }

  private:
    [[noreturn]] void fail() const {
        throw std::system_error(errno, std::generic_category(), path_.string());
    }

    const fs::path& path_;
    int file_;
};

std::string stamp_of(const struct stat& state) {
    return fmt::format("{} {} {} {}.{:09} {}.{:09}", state.st_dev, state.st_ino, state.st_size,
                       state.st_mtim.tv_sec, state.st_mtim.tv_nsec, state.st_ctim.tv_sec,
                       state.st_ctim.tv_nsec);
}

/// Times of files are too coarse to tell a change from another right before it.
bool has_rested(const struct stat& state) {
    constexpr std::time_t seconds = 2;
    return state.st_ctim.tv_sec + seconds < std::time(nullptr);
}

constexpr std::size_t digest_length = 64, stamp_words = 5;

bool is_digest(std::string_view text) {
    return text.size() == digest_length &&
           text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace

FileDigests::FileDigests(fs::path file) : file_(std::move(file)), known_(read(file_)) {}

FileDigests::~FileDigests() {
    try {
        if (!file_.empty() && !added_.empty()) write();
    } catch (const std::exception&) {
        // Computed again next time.
    }
}

std::string FileDigests::of(const fs::path& path, const std::stop_token& stop) {
    const OpenFile file(path);
    const auto state = file.state();
    const std::string stamp = stamp_of(state);
    const auto found = known_.find(path.string());
    if (found != known_.end() && found->second.stamp == stamp) return found->second.digest;
    Sha256 digest;
    std::vector<char> buffer(std::size_t{1} << 20);
    for (std::size_t size = 0; file.read(buffer, size);) {
        if (stop.stop_requested()) throw Interrupted();
        digest.add({buffer.data(), size});
    }
    Remembered fresh{.stamp = stamp, .digest = digest.hex()};
    const bool one_line = path.string().find('\n') == std::string::npos;
    if (one_line && has_rested(state) && stamp_of(file.state()) == stamp) {
        added_[path.string()] = fresh;
        known_[path.string()] = fresh;
    }
    return fresh.digest;
}

/// Lines "digest stamp path"; what is no such line is left out.
std::map<std::string, FileDigests::Remembered> FileDigests::read(const fs::path& file) {
    std::map<std::string, Remembered> known;
    std::error_code error;
    constexpr std::uintmax_t largest = std::uintmax_t{16} << 20;
    if (file.empty() || !fs::is_regular_file(file, error) || fs::file_size(file, error) > largest)
        return known;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        const std::string digest = line.substr(0, digest_length);
        std::size_t end = digest_length;
        for (std::size_t word = 0; word < stamp_words && end != std::string::npos; ++word)
            end = line.find(' ', end + 1);
        if (!is_digest(digest) || end == std::string::npos) continue;
        known[line.substr(end + 1)] = {
            .stamp = line.substr(digest_length + 1, end - digest_length - 1), .digest = digest};
    }
    return known;
}

/// With what others have written meanwhile, under another name first.
void FileDigests::write() const {
    auto all = read(file_);
    for (const auto& [path, remembered] : added_)
        all[path] = remembered;
    fs::create_directories(file_.parent_path());
    const fs::path unfinished = fmt::format("{}.{}", file_.string(), getpid());
    std::ofstream out(unfinished);
    for (const auto& [path, remembered] : all)
        out << remembered.digest << ' ' << remembered.stamp << ' ' << path << '\n';
    out.close();
    std::error_code error;
    if (out) fs::rename(unfinished, file_, error);
    if (!out || error) fs::remove(unfinished, error);
}

fs::path FileDigests::usual_place() {
    const char* cache = std::getenv("XDG_CACHE_HOME");
    if (cache != nullptr && *cache == '/') return fs::path(cache) / "crossgrain/file-digests";
    const char* home = std::getenv("HOME");
    if (home != nullptr && *home == '/') return fs::path(home) / ".cache/crossgrain/file-digests";
    return {};
}

}  // namespace crossgrain::adapters::process
