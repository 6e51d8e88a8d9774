#include "native/base/cpu_time.hpp"

#include <ctime>

namespace crossgrain {
namespace {

double seconds(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

double thread_cpu_seconds() {
    return seconds(CLOCK_THREAD_CPUTIME_ID);
}

double process_cpu_seconds() {
    return seconds(CLOCK_PROCESS_CPUTIME_ID);
}

}  // namespace crossgrain
