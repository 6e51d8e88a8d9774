// Threads that wait for the next piece of work, so that a time step costs a handshake and not the
// start of threads. They spin for some microseconds before they sleep: steps follow each other.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

namespace crossgrain::dem {

class ThreadTeam {
  public:
    /// `threads` >= 1, the calling thread included.
    explicit ThreadTeam(int threads);
    ~ThreadTeam();
    ThreadTeam(const ThreadTeam&) = delete;
    ThreadTeam& operator=(const ThreadTeam&) = delete;

    [[nodiscard]] std::size_t size() const noexcept { return workers_.size() + 1; }

    /// work(thread), thread = 0 ... size() - 1, all at once; returns when all are done. `work` must
    /// not throw.
    template <class Work>
    void run(const Work& work) {
        if (workers_.empty()) {
            work(std::size_t{0});
            return;
        }
        call_ = [](const void* what, std::size_t thread) {
            (*static_cast<const Work*>(what))(thread);
        };
        work_ = &work;
        start();
        work(std::size_t{0});
        wait_for_workers();
    }

    /// work(begin, end, thread) on parts of 0 ... count that begin at multiples of `grain`.
    template <class Work>
    void split(std::size_t count, std::size_t grain, const Work& work) {
        const std::size_t pieces = (count + grain - 1) / grain;
        run([&](std::size_t thread) {
            const std::size_t begin = pieces * thread / size() * grain;
            const std::size_t end = pieces * (thread + 1) / size() * grain;
            if (begin < count) work(begin, end < count ? end : count, thread);
        });
    }

  private:
    void start();
    void wait_for_workers();
    void serve(std::size_t thread);

    std::atomic<std::uint64_t> round_{0};  ///< counts pieces of work
    std::atomic<std::size_t> busy_{0};
    std::atomic<bool> over_{false};
    void (*call_)(const void*, std::size_t) = nullptr;
    const void* work_ = nullptr;
    std::vector<std::jthread> workers_;
};

}  // namespace crossgrain::dem
