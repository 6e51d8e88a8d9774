#include "cases/measure/bed/layer_spectrum.hpp"

#include "native/base/fft_planner.hpp"

#include <fftw3.h>

#include <algorithm>
#include <cassert>
#include <mutex>

namespace crossgrain::measure {

struct LayerSpectrum::Plan {
    explicit Plan(std::size_t cells)
        : n(cells), in(fftw_alloc_real(cells)), out(fftw_alloc_complex(cells / 2 + 1)) {
        const std::lock_guard lock(fft_planner());
        plan = fftw_plan_dft_r2c_1d(static_cast<int>(n), in, out, FFTW_ESTIMATE);
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

    std::size_t n;
    double* in;
    fftw_complex* out;
    fftw_plan plan = nullptr;
};

LayerSpectrum::LayerSpectrum(std::size_t cells) : plan_(std::make_unique<Plan>(cells)) {}
LayerSpectrum::~LayerSpectrum() = default;
LayerSpectrum::LayerSpectrum(LayerSpectrum&&) noexcept = default;
LayerSpectrum& LayerSpectrum::operator=(LayerSpectrum&&) noexcept = default;

std::size_t LayerSpectrum::cells() const noexcept {
    return plan_->n;
}

std::vector<double> LayerSpectrum::operator()(std::span<const double> row) {
    assert(row.size() == plan_->n);
    std::ranges::copy(row, plan_->in);
    fftw_execute(plan_->plan);
    std::vector<double> power(plan_->n / 2 + 1);
    for (std::size_t k = 0; k < power.size(); ++k) {
        const auto& f = plan_->out[k];
        power[k] = f[0] * f[0] + f[1] * f[1];
    }
    return power;
}

}  // namespace crossgrain::measure
