#include "app/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace crossgrain::app {
namespace {

std::string duration_text(double seconds) {
    if (seconds < 90) return fmt::format("{:.0f} s", seconds);
    if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
    return fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

Progress::Progress(bool quiet, std::size_t runs, double total_work)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1), runs_(runs), total_work_(total_work),
      start_(Clock::now()), drawn_(start_) {}

Progress::~Progress() {
    clear_line();
}

void Progress::advanced(const std::string& run, double work, double fraction) {
    const std::lock_guard lock(mutex_);
    running_work_[run] = work * fraction;
    using namespace std::chrono_literals;
    if (quiet_ || !terminal_ || Clock::now() - drawn_ < 200ms) return;
    redraw();
}

void Progress::finished(const std::string& run, double work, const std::string& how) {
    const std::lock_guard lock(mutex_);
    running_work_.erase(run);
    ended_work_ += work;
    ++ended_;
    if (quiet_) return;
    if (terminal_) {
        redraw();
        return;
    }
    fmt::print(stderr, "[{}/{}] {}: {}\n", ended_, runs_, run, how);
}

double Progress::work_done() const {
    double done = ended_work_;
    for (const auto& [run, work] : running_work_)
        done += work;
    return done;
}

void Progress::redraw() {
    drawn_ = Clock::now();
    const double fraction = total_work_ > 0 ? std::min(1.0, work_done() / total_work_) : 1.0;
    const double elapsed = std::chrono::duration<double>(drawn_ - start_).count();
    constexpr int width = 30;
    const int filled = static_cast<int>(fraction * width);
    std::string names;
    for (const auto& [run, work] : running_work_)
        names += " " + run;
    fmt::print(stderr, "\r\033[K[{:#<{}}{:.<{}}] {}/{} runs, {} left{:.60}", "", filled, "",
               width - filled, ended_, runs_,
               fraction > 0.01 ? duration_text(elapsed * (1 - fraction) / fraction) : "?", names);
    std::fflush(stderr);
}

void Progress::clear_line() const {
    if (terminal_ && !quiet_) fmt::print(stderr, "\r\033[K");
}

}  // namespace crossgrain::app
