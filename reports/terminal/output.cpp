#include "reports/terminal/output.hpp"

#include "native/base/printable.hpp"
#include "reports/documents/json_text.hpp"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace crossgrain::terminal {
namespace {

/// errno of the first write to stdout that failed.
int first_loss = 0;

void remember_loss() noexcept {
    if (first_loss == 0) first_loss = errno != 0 ? errno : EIO;
}

void write_result_bytes(std::string_view bytes) noexcept {
    errno = 0;
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size()) remember_loss();
}

}  // namespace

void open_standard_streams() {
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(descriptor, F_GETFD) != -1 || errno != EBADF) continue;
        // The lowest free descriptor is this one. Opened the wrong way round, every use fails.
        const int opened = open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
        if (opened == -1) return;  // without /dev/null there is nothing to put in its place
    }
}

void print_result_text(std::string_view text) {
    write_result_bytes(printable_lines(text, std::string::npos));
}

void print_document(const nlohmann::json& document) {
    write_result_bytes(reports::json_text(document) + "\n");
}

void flush_results() noexcept {
    errno = 0;
    if (std::fflush(stdout) != 0) remember_loss();
}

std::optional<std::string> lost_results() {
    flush_results();
    if (first_loss == 0) return std::nullopt;
    return std::generic_category().message(first_loss);
}

void write_to_stderr(std::string_view bytes) noexcept {
    static std::atomic_flag told;
    while (!bytes.empty()) {
        const ssize_t written = ::write(STDERR_FILENO, bytes.data(), bytes.size());
        if (written >= 0) {
            bytes.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno != EINTR) {
            // To the process, not to this thread: the thread that waits for signals takes it. Once,
            // since a second signal means more than a first.
            if (errno == EPIPE && !told.test_and_set()) ::kill(::getpid(), SIGPIPE);
            return;
        }
    }
}

void print_note_text(std::string_view text) {
    write_to_stderr(printable_lines(text, std::string::npos) + "\n");
}

std::exception_ptr failure_of(const std::function<void()>& write) {
    try {
        write();
        return nullptr;
    } catch (...) {
        return std::current_exception();
    }
}

}  // namespace crossgrain::terminal
