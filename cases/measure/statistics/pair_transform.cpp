#include "cases/measure/statistics/pair_transform.hpp"

#include "native/base/fft_planner.hpp"

#include <fftw3.h>

namespace crossgrain::measure {

struct PairTransform::Plan {
    explicit Plan(std::size_t points)
        : n(points), in(fftwf_alloc_complex(points)), out(fftwf_alloc_complex(points)) {
        const std::lock_guard lock(fft_planner());
        // Estimated, not measured: a measured plan depends on the load of the machine, and the same
        // run must give the same bits.
        plan = fftwf_plan_dft_1d(static_cast<int>(n), in, out, FFTW_FORWARD,
                                 FFTW_ESTIMATE | FFTW_PRESERVE_INPUT);
    }
    ~Plan() {
        {
            const std::lock_guard lock(fft_planner());
            fftwf_destroy_plan(plan);
        }
        fftwf_free(in);
        fftwf_free(out);
    }
    Plan(const Plan&) = delete;
    Plan& operator=(const Plan&) = delete;

    [[nodiscard]] std::complex<float> operator[](std::size_t k) const noexcept {
        return {out[k][0], out[k][1]};
    }

    std::size_t n;
    fftwf_complex* in;
    fftwf_complex* out;
    fftwf_plan plan = nullptr;
};

PairTransform::PairTransform(std::size_t points) : plan_(std::make_unique<Plan>(points)) {}
PairTransform::~PairTransform() = default;
PairTransform::PairTransform(PairTransform&&) noexcept = default;

std::span<std::complex<float>> PairTransform::input() noexcept {
    // FFTW's complex numbers have the layout of std::complex.
    return {reinterpret_cast<std::complex<float>*>(plan_->in), plan_->n};
}

void PairTransform::forward() {
    fftwf_execute(plan_->plan);
}

std::array<std::complex<float>, 2> PairTransform::at(std::size_t k) const noexcept {
    const std::complex<float> plus = (*plan_)[k];
    const std::complex<float> minus = std::conj((*plan_)[(plan_->n - k) % plan_->n]);
    const std::complex<float> sum = plus + minus, difference = plus - minus;
    return {0.5F * sum, std::complex<float>(0.5F * difference.imag(), -0.5F * difference.real())};
}

void PairTransform::add_power(std::span<double> first, std::span<double> second) const noexcept {
    for (std::size_t k = 0; k <= plan_->n / 2; ++k) {
        const auto [a, b] = at(k);
        first[k] += static_cast<double>(std::norm(a));
        second[k] += static_cast<double>(std::norm(b));
    }
}

}  // namespace crossgrain::measure
