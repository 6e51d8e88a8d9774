#include "app/signal_stop.hpp"

#include "app/exit_code.hpp"

#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <system_error>

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

namespace crossgrain::app {

using Clock = std::chrono::steady_clock;

namespace {

// Ignored by default; interrupts system calls that block, e.g. opening a pipe that nobody writes.
constexpr int wake_signal = SIGURG;

int checked(int file, const char* what) {
    if (file < 0) throw std::system_error(errno, std::generic_category(), what);
    return file;
}

bool is_ignored(int signal) {
    struct sigaction action {};
    return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

SignalStop::SignalStop() {
    sigemptyset(&signals_);
    for (const int signal : {SIGINT, SIGTERM, SIGQUIT, SIGPIPE})
        sigaddset(&signals_, signal);
    if (!is_ignored(SIGHUP)) sigaddset(&signals_, SIGHUP);
    pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
    // A write beyond the limit of file sizes fails, as it does on a full disk.
    (void)std::signal(SIGXFSZ, SIG_IGN);
    struct sigaction nothing {};  // without SA_RESTART
    nothing.sa_handler = [](int) {};
    sigaction(wake_signal, &nothing, nullptr);
    signal_file_ = checked(signalfd(-1, &signals_, SFD_CLOEXEC | SFD_NONBLOCK), "signalfd");
    end_file_ = checked(eventfd(0, EFD_CLOEXEC), "eventfd");
    thread_ = std::thread([this] { wait(); });
}

SignalStop::~SignalStop() {
    const std::uint64_t one = 1;
    (void)!write(end_file_, &one, sizeof one);
    thread_.join();
    close(end_file_);
    close(signal_file_);
}

std::stop_token SignalStop::listen() {
    listening_ = true;
    return source_.get_token();
}

SignalStop::News SignalStop::next(int milliseconds) const {
    pollfd events[] = {{.fd = end_file_, .events = POLLIN, .revents = 0},
                       {.fd = signal_file_, .events = POLLIN, .revents = 0}};
    const int count = poll(events, 2, milliseconds);
    if (count > 0 && events[0].revents != 0) return News::end;
    signalfd_siginfo signal{};
    if (count > 0 && read(signal_file_, &signal, sizeof signal) > 0) return News::signal;
    return News::nothing;
}

void SignalStop::wait() {
    constexpr auto longest_stop = std::chrono::seconds(5);
    constexpr auto longest_waking = std::chrono::seconds(1);
    constexpr int turn_milliseconds = 20;
    News news = News::nothing;
    while (news == News::nothing)
        news = next(-1);
    if (news == News::end) return;
    if (!listening_) std::_Exit(exit_interrupted);
    source_.request_stop();
    const auto start = Clock::now();
    do {
        // Again and again: the system call may only be about to begin.
        if (Clock::now() < start + longest_waking) pthread_kill(main_, wake_signal);
        news = next(turn_milliseconds);
    } while (news == News::nothing && Clock::now() < start + longest_stop);
    if (news != News::end) std::_Exit(exit_interrupted);
}

}  // namespace crossgrain::app
