#include "reports/terminal/progress.hpp"

#include "native/base/printable.hpp"
#include "reports/terminal/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>
#include <sys/ioctl.h>
#include <unistd.h>

namespace crossgrain::terminal {
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

class TerminalProgress final : public run::Progress {
  public:
    TerminalProgress(std::size_t runs, double total_seconds, unsigned workers);
    ~TerminalProgress() override;
    TerminalProgress(const TerminalProgress&) = delete;
    TerminalProgress& operator=(const TerminalProgress&) = delete;

    void advanced(const std::string& run, double seconds, double fraction) override;
    void finished(const std::string& run, double seconds, const std::string& how) override;

  private:
    void redraw();
    void clear_line() const;
    [[nodiscard]] double fraction_done() const;
    /// From the time it took so far; "?" before anything is known.
    [[nodiscard]] std::string time_left() const;

    using Clock = std::chrono::steady_clock;
    bool terminal_;
    std::size_t runs_, ended_ = 0;
    double total_, ended_seconds_ = 0;
    std::map<std::string, double> running_;
    Clock::time_point start_, drawn_;
    std::mutex mutex_;
};

TerminalProgress::TerminalProgress(std::size_t runs, double total_seconds, unsigned workers)
    : terminal_(isatty(STDERR_FILENO) == 1), runs_(runs), total_(total_seconds),
      start_(Clock::now()), drawn_(start_) {
    print_note("{} {} to compute, about {} with {} side by side", runs, runs == 1 ? "run" : "runs",
               duration_text(total_seconds / workers), workers);
}

TerminalProgress::~TerminalProgress() {
    clear_line();
}

void TerminalProgress::advanced(const std::string& run, double seconds, double fraction) {
    const std::lock_guard lock(mutex_);
    running_[run] = seconds * fraction;
    using namespace std::chrono_literals;
    if (!terminal_ || Clock::now() - drawn_ < 200ms) return;
    redraw();
}

void TerminalProgress::finished(const std::string& run, double seconds, const std::string& how) {
    const std::lock_guard lock(mutex_);
    running_.erase(run);
    ended_seconds_ += seconds;
    ++ended_;
    if (terminal_) {
        redraw();
        return;
    }
    print_note("[{}/{}, {} left] {}: {}", ended_, runs_, time_left(), printable(run),
               printable(how));
}

double TerminalProgress::fraction_done() const {
    double done = ended_seconds_;
    for (const auto& [run, seconds] : running_)
        done += seconds;
    return total_ > 0 ? std::min(1.0, done / total_) : 1.0;
}

std::string TerminalProgress::time_left() const {
    const double fraction = fraction_done();
    const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
    return fraction > 0.01 ? duration_text(elapsed * (1 - fraction) / fraction) : "?";
}

void TerminalProgress::redraw() {
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

void TerminalProgress::clear_line() const {
    if (terminal_) write_to_stderr("\r\033[K");
}

}  // namespace

void TerminalMonitor::note(const std::string& line) {
    print_note("{}", line);
}

void TerminalMonitor::remark(const std::string& line) {
    if (!quiet_) print_note("{}", line);
}

std::unique_ptr<run::Progress> TerminalMonitor::begin(std::size_t runs, double total_seconds,
                                                      unsigned workers) {
    if (quiet_) return run::silent_monitor().begin(runs, total_seconds, workers);
    return std::make_unique<TerminalProgress>(runs, total_seconds, workers);
}

}  // namespace crossgrain::terminal
