// The machine that numbers were computed on, for reports.
#pragma once

#include <string>

namespace crossgrain {

struct Machine {
    std::string cpu, os;  ///< as /proc/cpuinfo and /etc/os-release name them, or "unknown"
    unsigned cores = 0;
};
[[nodiscard]] Machine this_machine();

}  // namespace crossgrain
