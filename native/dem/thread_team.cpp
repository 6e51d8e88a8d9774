#include "native/dem/thread_team.hpp"

namespace crossgrain::dem {
namespace {

/// Waits until the value differs from `old`: first awake, then asleep.
template <class T>
T wait_for_change(const std::atomic<T>& value, T old) {
    // Some 20 microseconds: longer only where a thread has lost its core to somebody else.
    constexpr int awake = 1000;
    for (int i = 0; i < awake; ++i) {
        const T now = value.load(std::memory_order_acquire);
        if (now != old) return now;
#if defined(__x86_64__)
        __builtin_ia32_pause();
#endif
    }
    value.wait(old, std::memory_order_acquire);
    return value.load(std::memory_order_acquire);
}

}  // namespace

ThreadTeam::ThreadTeam(int threads) {
    for (int thread = 1; thread < threads; ++thread)
        workers_.emplace_back([this, thread] { serve(static_cast<std::size_t>(thread)); });
}

ThreadTeam::~ThreadTeam() {
    over_ = true;
    ++round_;
    round_.notify_all();
}

void ThreadTeam::start() {
    busy_.store(workers_.size(), std::memory_order_relaxed);
    round_.fetch_add(1, std::memory_order_release);
    round_.notify_all();
}

void ThreadTeam::wait_for_workers() {
    for (std::size_t busy = busy_; busy != 0;)
        busy = wait_for_change(busy_, busy);
}

void ThreadTeam::serve(std::size_t thread) {
    for (std::uint64_t seen = 0;;) {
        seen = wait_for_change(round_, seen);
        if (over_) return;
        call_(work_, thread);
        if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_all();
    }
}

}  // namespace crossgrain::dem
