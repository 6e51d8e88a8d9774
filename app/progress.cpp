#include "app/progress.hpp"

#include "app/output.hpp"
#include "native/base/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sys/ioctl.h>
#include <unistd.h>

namespace crossgrain::app {
namespace {

std::string duration_text(double seconds) {
    if (seconds < 90) return fmt::format("{:.0f} s", seconds);
    if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
    return fmt::format("{:.1f} h", seconds / 3600);
}

int terminal_columns() {
    winsize size{};
    const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? size.ws_col : 80;
}

}  // namespace

Progress::Progress(bool quiet, std::size_t runs, double total_seconds, unsigned workers)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1), runs_(runs), total_(total_seconds),
      start_(Clock::now()), drawn_(start_) {
    if (quiet_) return;
    print_note("{} {} to compute, about {} with {} side by side", runs, runs == 1 ? "run" : "runs",
               duration_text(total_seconds / workers), workers);
}

Progress::~Progress() {
    clear_line();
}

void Progress::advanced(const std::string& run, double seconds, double fraction) {
    const std::lock_guard lock(mutex_);
    running_[run] = seconds * fraction;
    using namespace std::chrono_literals;
    if (quiet_ || !terminal_ || Clock::now() - drawn_ < 200ms) return;
    redraw();
}

void Progress::finished(const std::string& run, double seconds, const std::string& how) {
    const std::lock_guard lock(mutex_);
    running_.erase(run);
    ended_seconds_ += seconds;
    ++ended_;
    if (quiet_) return;
    if (terminal_) {
        redraw();
        return;
    }
    print_note("[{}/{}, {} left] {}: {}", ended_, runs_, time_left(), printable(run),
               printable(how));
}

double Progress::fraction_done() const {
    double done = ended_seconds_;
    for (const auto& [run, seconds] : running_)
        done += seconds;
    return total_ > 0 ? std::min(1.0, done / total_) : 1.0;
}

std::string Progress::time_left() const {
    const double fraction = fraction_done();
    const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
    return fraction > 0.01 ? duration_text(elapsed * (1 - fraction) / fraction) : "?";
}

void Progress::redraw() {
    drawn_ = Clock::now();
    constexpr int width = 30;
    const int filled = static_cast<int>(fraction_done() * width);
    std::string names;
    for (const auto& [run, seconds] : running_)
        names += " " + printable(run);
    const std::string line = fmt::format("[{:#<{}}{:.<{}}] {}/{} runs, {} left{:.60}", "", filled,
                                         "", width - filled, ended_, runs_, time_left(), names);
    // A line that is wrapped could not be rewritten.
    write_to_stderr(fmt::format("\r\033[K{:.{}}", line, terminal_columns() - 1));
}

void Progress::clear_line() const {
    if (terminal_ && !quiet_) write_to_stderr("\r\033[K");
}

}  // namespace crossgrain::app
