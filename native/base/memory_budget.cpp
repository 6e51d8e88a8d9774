#include "native/base/memory_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include <sys/resource.h>
#include <unistd.h>

namespace crossgrain {

double memory_budget() {
    double least = 8.0 * 0x1p30;
    const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE);
    if (pages > 0 && page > 0) {
        least = std::min(least, static_cast<double>(pages) * static_cast<double>(page));
    }
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
        least = std::min(least, static_cast<double>(limit.rlim_cur));
    }
    return least;
}

void require_memory(double bytes, std::string_view what) {
    if (bytes <= memory_budget()) return;
    throw std::invalid_argument(fmt::format("{} need {}, of at most {}", what, shown_bytes(bytes),
                                            shown_bytes(memory_budget())));
}

std::string shown_bytes(double bytes) {
    const char* unit = "bytes";
    for (const char* larger : {"KiB", "MiB", "GiB", "TiB"}) {
        if (bytes < 1024) break;
        bytes /= 1024;
        unit = larger;
    }
    return fmt::format("{:.3g} {}", bytes, unit);
}

}  // namespace crossgrain
