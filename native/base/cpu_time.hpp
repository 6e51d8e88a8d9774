// Processor time that was spent, whatever else the machine was doing meanwhile.
#pragma once

namespace crossgrain {

/// User and system time of the calling thread (s).
[[nodiscard]] double thread_cpu_seconds();

/// User and system time of all threads of this process (s).
[[nodiscard]] double process_cpu_seconds();

}  // namespace crossgrain
