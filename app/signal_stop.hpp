// What signals that ask a program to end do to this one.
#pragma once

#include <atomic>
#include <csignal>
#include <stop_token>
#include <thread>

#include <pthread.h>

namespace crossgrain::app {

/// SIGINT, SIGTERM, SIGHUP (unless ignored: nohup), SIGQUIT and SIGPIPE become a stop request. A
/// second one of any kind ends the program at once with exit_interrupted; so does the first one
/// while nobody listens, and a stop that takes longer than a few seconds. Nothing is lost then:
/// finished runs are stored at once, guards end the programs of the others, and the next call
/// sweeps their directories.
/// A thread waits for them, because little may be done in a signal handler. To be made before any
/// other thread: all of them must have these signals blocked. A write to a closed pipe then fails
/// with EPIPE instead of ending the program.
class SignalStop {
  public:
    SignalStop();
    ~SignalStop();
    SignalStop(const SignalStop&) = delete;
    SignalStop& operator=(const SignalStop&) = delete;

    /// From now on somebody looks at the token every now and then.
    [[nodiscard]] std::stop_token listen();
    [[nodiscard]] bool requested() const { return source_.stop_requested(); }

  private:
    void wait();
    /// What has happened within a time; a negative one is for ever.
    enum class News { signal, nothing, end };
    [[nodiscard]] News next(int milliseconds) const;

    sigset_t signals_{};
    int signal_file_ = -1;
    int end_file_ = -1;
    pthread_t main_ = pthread_self();
    std::atomic<bool> listening_ = false;
    std::stop_source source_;
    std::thread thread_;
};

}  // namespace crossgrain::app
