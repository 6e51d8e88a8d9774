#include "adapters/process/child.hpp"

#include "adapters/process/guard_program.hpp"

#include <cerrno>
#include <csignal>
#include <string>
#include <system_error>

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace crossgrain::adapters::process {

using guard::Report;

namespace {

[[noreturn]] void fail(int error, const std::string& what) {
    throw std::system_error(error, std::generic_category(), what);
}

std::vector<std::string> order_of(const ChildSetup& setup) {
    std::vector<std::string> order{guard::protocol,
                                   setup.program.string(),
                                   setup.directory.string(),
                                   setup.stdout_file.string(),
                                   setup.stderr_file.string(),
                                   std::to_string(setup.largest_file)};
    order.insert(order.end(), setup.argv.begin(), setup.argv.end());
    return order;
}

std::string what_failed(const ChildSetup& setup, const Report& report) {
    switch (report.step) {
    case guard::Step::start:
        break;
    case guard::Step::enter_directory:
        return "cannot enter " + setup.directory.string();
    case guard::Step::open_stdout:
        return "cannot write " + setup.stdout_file.string();
    case guard::Step::open_stderr:
        return "cannot write " + setup.stderr_file.string();
    case guard::Step::execute:
        // The program itself is there, or it would not have been found.
        if (report.number == ENOENT)
            return "cannot start " + setup.program.string() + ", its interpreter is missing";
        break;
    }
    return "cannot start " + setup.program.string();
}

}  // namespace

Child::Child(const ChildSetup& setup) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) fail(errno, "socketpair");
    socket_ = ends[0];
    try {
        guard_ = start_guard(ends[1], order_of(setup), setup.environment);
    } catch (...) {
        close(ends[0]);
        close(ends[1]);
        throw;
    }
    close(ends[1]);
    Report report;
    ssize_t got = 0;
    while ((got = recv(socket_, &report, sizeof report, 0)) < 0 && errno == EINTR) {
    }
    if (got == sizeof report && report.kind == Report::Kind::started) {
        program_ = report.number;
        return;
    }
    dismiss();
    if (got == sizeof report) fail(report.number, what_failed(setup, report));
    fail(ECHILD, "cannot start " + setup.program.string() + ": its guard ended at once");
}

Child::~Child() {
    dismiss();
}

/// The guard ends everybody when its socket is closed, and then itself.
void Child::dismiss() noexcept {
    if (guard_ < 0) return;
    close(socket_);
    while (waitpid(guard_, nullptr, 0) < 0 && errno == EINTR) {
    }
    guard_ = -1;
}

/// Takes the guard's last report, if it is there by now or, with `wait`, when it comes.
void Child::receive(bool wait) {
    Report report;
    while (!last_) {
        const ssize_t got = recv(socket_, &report, sizeof report, wait ? 0 : MSG_DONTWAIT);
        if (got == sizeof report) {
            last_ = report;
        } else if (got < 0 && errno == EAGAIN) {
            return;
        } else if (got >= 0 || (errno != EINTR && errno != ECONNRESET)) {
            // (It is reset, but not empty, if the guard ended before it had heard our last
            // request.) The program itself is killed with its guard (PR_SET_PDEATHSIG), but not its
            // children.
            kill(-program_, SIGKILL);
            fail(ECHILD, "the guard of a program was killed");
        }
    }
}

void Child::request(guard::Request what) const noexcept {
    // Fails only when nobody is left, which is what is wanted.
    (void)send(socket_, &what, sizeof what, MSG_NOSIGNAL);
}

bool Child::has_ended() {
    receive(false);
    return last_.has_value();
}

void Child::ask_to_end() const noexcept {
    request(guard::Request::end);
}

Reaped Child::reap() {
    request(guard::Request::kill);
    receive(true);
    dismiss();
    return {.signalled = last_->signalled != 0, .status = last_->number, .cpu_s = last_->cpu_s};
}

}  // namespace crossgrain::adapters::process
