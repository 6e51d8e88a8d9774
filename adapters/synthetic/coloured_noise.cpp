#include "adapters/synthetic/coloured_noise.hpp"

#include "native/base/fft_planner.hpp"
#include "native/base/random.hpp"

#include <fftw3.h>

#include <bit>
#include <cmath>

namespace crossgrain::adapters {

struct ColouredNoise::Plan {
    explicit Plan(std::size_t points)
        : in(fftw_alloc_complex(points / 2 + 1)), out(fftw_alloc_real(points)) {
        const std::lock_guard lock(fft_planner());
        plan = fftw_plan_dft_c2r_1d(static_cast<int>(points), in, out, FFTW_ESTIMATE);
    }
    ~Plan() {
        {
            const std::lock_guard lock(fft_planner());
            fftw_destroy_plan(plan);
        }
        fftw_free(in);
        fftw_free(out);
    }
    Plan(const Plan&) = delete;
    Plan& operator=(const Plan&) = delete;

    fftw_complex* in;
    double* out;
    fftw_plan plan = nullptr;
};

ColouredNoise::ColouredNoise(std::size_t length, double exponent, double deviation)
    : length_(length) {
    const std::size_t period = std::bit_ceil(2 * length);
    amplitudes_.assign(period / 2 + 1, 0.0);
    double variance = 0;  // of the series for the amplitudes f^(-alpha/2)
    for (std::size_t k = 1; k <= period / 2; ++k) {
        const double power = std::pow(static_cast<double>(k), -exponent);
        amplitudes_[k] = std::sqrt(power);
        // Re^2 + Im^2 at k and at -k; the highest frequency is its own mirror image and real.
        variance += k < period / 2 ? 4 * power : power;
    }
    for (double& amplitude : amplitudes_)
        amplitude *= deviation / std::sqrt(variance);
    plan_ = std::make_unique<Plan>(period);
}

ColouredNoise::~ColouredNoise() = default;

std::span<const double> ColouredNoise::series(std::uint64_t seed, std::uint64_t number) {
    for (std::size_t k = 0; k < amplitudes_.size(); ++k) {
        const auto normal = normal_pair(seed, RandomStream::signal, number << 32 | k);
        plan_->in[k][0] = amplitudes_[k] * normal[0];
        plan_->in[k][1] = k + 1 < amplitudes_.size() ? amplitudes_[k] * normal[1] : 0.0;
    }
    fftw_execute(plan_->plan);
    return {plan_->out, length_};
}

}  // namespace crossgrain::adapters
