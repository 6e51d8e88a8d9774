// FFTW makes and destroys plans with tables that all threads share; only executing them is safe.
// Whoever makes or destroys a plan holds this lock.
#pragma once

#include <mutex>

namespace crossgrain {

[[nodiscard]] inline std::mutex& fft_planner() {
    static std::mutex mutex;
    return mutex;
}

}  // namespace crossgrain
