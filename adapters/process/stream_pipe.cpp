#include "adapters/process/stream_pipe.hpp"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

namespace crossgrain::adapters::process {

namespace {

// The largest that Linux grants without privilege: fewer switches between program and reader.
constexpr std::size_t buffer_size = std::size_t{1} << 20;

[[noreturn]] void fail(const char* what) {
    throw std::system_error(errno, std::generic_category(), what);
}

}  // namespace

StreamPipe::StreamPipe(const std::filesystem::path& path) : buffer_(buffer_size) {
    if (mkfifo(path.c_str(), 0600) != 0) fail(path.c_str());
    reading_ = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (reading_ < 0) fail(path.c_str());
    writing_ = open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    if (writing_ < 0) {
        close(reading_);
        fail(path.c_str());
    }
    // Only a matter of speed: a smaller pipe is right as well.
    fcntl(reading_, F_SETPIPE_SZ, static_cast<int>(buffer_size));
}

StreamPipe::~StreamPipe() {
    close(writing_);
    close(reading_);
}

void StreamPipe::wait(int milliseconds) const {
    pollfd waiting{.fd = reading_, .events = POLLIN, .revents = 0};
    if (poll(&waiting, 1, milliseconds) < 0 && errno != EINTR) fail("poll");
}

std::string_view StreamPipe::read() {
    while (true) {
        const ssize_t got = ::read(reading_, buffer_.data(), buffer_.size());
        if (got >= 0) return {buffer_.data(), static_cast<std::size_t>(got)};
        if (errno == EAGAIN || errno == EWOULDBLOCK) return {};
        if (errno != EINTR) fail("read from pipe");
    }
}

}  // namespace crossgrain::adapters::process
