// crossgrain-guard: starts one program and ends everybody whom it brought along, when the program
// has ended, when it is told to, and when whoever started the guard is gone, however that happened.
// A program of its own, because a signal may kill crossgrain, but not two at once; and a copy of
// crossgrain (fork) would hold a copy of all its memory. Started by process::Child alone.
#include "adapters/process/guard/descendants.hpp"
#include "adapters/process/guard/protocol.hpp"
#include "adapters/process/guard/start.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using namespace crossgrain::adapters::process::guard;

void tell(const Report& report) {
    // Fails only when nobody listens any more.
    (void)send(socket_number, &report, sizeof report, MSG_NOSIGNAL);
}

double seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Blocks all signals; the descriptor tells of children that end.
int block_signals() {
    sigset_t all, child;
    sigfillset(&all);
    sigprocmask(SIG_SETMASK, &all, nullptr);
    sigemptyset(&child);
    sigaddset(&child, SIGCHLD);
    return signalfd(-1, &child, SFD_CLOEXEC | SFD_NONBLOCK);
}

/// Carries out what the socket says; false when everybody is to be killed.
bool obey(const Descendants& descendants) {
    char request = 0;
    const ssize_t got = recv(socket_number, &request, 1, MSG_DONTWAIT);
    if (got < 0) return errno == EAGAIN || errno == EINTR;
    if (got == 0 || static_cast<Request>(request) == Request::kill) return false;
    descendants.signal_group(SIGTERM);
    // Somebody who is suspended would not even hear of it.
    descendants.signal_group(SIGCONT);
    return true;
}

/// Until the program has ended, or everybody is to be killed.
void watch(Descendants& descendants, int ended_children) {
    while (!descendants.reap_others()) {
        pollfd events[] = {{.fd = socket_number, .events = POLLIN, .revents = 0},
                           {.fd = ended_children, .events = POLLIN, .revents = 0}};
        // Without a descriptor for ended children: look every now and then.
        const int longest_ms = ended_children < 0 ? 5 : -1;
        if (poll(events, 2, longest_ms) < 0 && errno != EINTR) return;
        signalfd_siginfo news{};
        while (ended_children >= 0 && read(ended_children, &news, sizeof news) > 0) {
        }
        if (events[0].revents != 0 && !obey(descendants)) return;
    }
}

Report final_report(const Descendants& descendants) {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    const int status = descendants.status().value_or(SIGKILL);
    const bool signalled = WIFSIGNALED(status);
    return {.kind = Report::Kind::ended,
            .number = signalled ? WTERMSIG(status) : WEXITSTATUS(status),
            .signalled = signalled ? 1 : 0,
            .cpu_s = seconds(usage.ru_utime) + seconds(usage.ru_stime)};
}

}  // namespace

int main(int argc, char** argv) {
    if (argc <= argument_argv || std::strcmp(argv[argument_protocol], protocol) != 0) {
        std::fputs("crossgrain starts this program itself; if it said so, build both anew\n",
                   stderr);
        return 2;
    }
    // It was inherited; the program must not inherit it, or nobody would see it closed.
    fcntl(socket_number, F_SETFD, FD_CLOEXEC);
    const int ended_children = block_signals();
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    const auto started =
        start({.program = argv[argument_program],
               .directory = argv[argument_directory],
               .stdout_file = argv[argument_stdout],
               .stderr_file = argv[argument_stderr],
               .largest_file = std::strtoull(argv[argument_largest_file], nullptr, 10),
               .argv = argv + argument_argv});
    if (const auto* failure = std::get_if<StartFailure>(&started)) {
        tell({.kind = Report::Kind::failed, .step = failure->step, .number = failure->error});
        return 0;
    }
    const pid_t leader = std::get<pid_t>(started);
    tell({.kind = Report::Kind::started, .number = leader});
    Descendants descendants(leader);
    watch(descendants, ended_children);
    constexpr std::chrono::seconds patience(10);
    descendants.end(patience);
    tell(final_report(descendants));
    return 0;
}
