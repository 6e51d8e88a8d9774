#include "native/base/input_file.hpp"

#include "native/base/errors.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

namespace crossgrain {
namespace {

CaseError cannot_be_read(const std::string& file, const std::string& expected, std::string why) {
    return CaseError({.file = file,
                      .problem = "cannot be read",
                      .got = {},
                      .expected = expected,
                      .hint = std::move(why)});
}

}  // namespace

InputFile::InputFile(std::string file, std::string expected, std::stop_token stop)
    : file_(std::move(file)), expected_(std::move(expected)), stop_(std::move(stop)) {
    // Without O_NONBLOCK a pipe that nobody writes to would not even open.
    descriptor_ = open(file_.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (descriptor_ < 0) throw cannot_be_read(file_, expected_, std::strerror(errno));
    struct stat status {};
    const bool known = fstat(descriptor_, &status) == 0;
    if (known && (S_ISREG(status.st_mode) || S_ISFIFO(status.st_mode))) return;
    close(descriptor_);
    const bool directory = known && S_ISDIR(status.st_mode);
    throw cannot_be_read(file_, expected_, directory ? "it is a directory" : "it is a device");
}

InputFile::~InputFile() {
    close(descriptor_);
}

void InputFile::wait() {
    constexpr int look_again = 100;  // ms
    while (true) {
        if (stop_.stop_requested()) throw Interrupted();
        pollfd waiting{.fd = descriptor_, .events = POLLIN, .revents = 0};
        const int ready = poll(&waiting, 1, look_again);
        if (ready > 0) return;
        if (ready < 0 && errno != EINTR) {
            throw cannot_be_read(file_, expected_, std::strerror(errno));
        }
    }
}

std::size_t InputFile::read(std::span<char> into) {
    while (true) {
        wait();
        const ssize_t got = ::read(descriptor_, into.data(), into.size());
        if (got >= 0) return static_cast<std::size_t>(got);
        if (errno != EINTR && errno != EAGAIN) {
            throw cannot_be_read(file_, expected_, std::strerror(errno));
        }
    }
}

std::optional<std::string> why_not_text(std::string_view beginning) {
    using namespace std::string_view_literals;
    struct Mark {
        std::string_view bytes;
        const char* meaning;
    };
    static constexpr Mark marks[] = {{"\x1f\x8b"sv, "is compressed (gzip)"},
                                     {"\x28\xb5\x2f\xfd"sv, "is compressed (zstd)"},
                                     {"\xfd"
                                      "7zXZ"sv,
                                      "is compressed (xz)"},
                                     {"BZh"sv, "is compressed (bzip2)"},
                                     {"PK\x03\x04"sv, "is compressed (zip)"},
                                     {"\xff\xfe"sv, "is UTF-16 text"},
                                     {"\xfe\xff"sv, "is UTF-16 text"}};
    for (const Mark& mark : marks) {
        if (beginning.starts_with(mark.bytes)) return mark.meaning;
    }
    constexpr std::size_t enough = 4096;
    const auto zero = beginning.substr(0, enough).find('\0');
    if (zero == std::string_view::npos) return std::nullopt;
    return fmt::format("is binary (byte {} is 0)", zero + 1);
}

}  // namespace crossgrain
