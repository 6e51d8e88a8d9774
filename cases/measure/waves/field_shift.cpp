#include "cases/measure/waves/field_shift.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>

namespace crossgrain::measure {

template <class T>
std::vector<float> fluctuation(FieldShape shape, std::span<const T> density, std::size_t rows) {
    const auto [bins, samples] = shape;
    std::vector<float> mean(samples, 0.0F), result(shape.size(), 0.0F);
    for (std::size_t i = 0; i < shape.size(); ++i)
        mean[i % samples] += static_cast<float>(density[i]);
    for (std::size_t i = 0; i < bins; ++i) {
        float* out = &result[i * samples];
        for (std::size_t k = 0; k < rows; ++k) {
            const T* in = &density[(i + bins + k - rows / 2) % bins * samples];
            for (std::size_t r = 0; r < samples; ++r)
                out[r] += static_cast<float>(in[r]);
        }
        for (std::size_t r = 0; r < samples; ++r) {
            out[r] = out[r] / static_cast<float>(rows) - mean[r] / static_cast<float>(bins);
        }
    }
    return result;
}

template std::vector<float> fluctuation(FieldShape, std::span<const std::uint16_t>, std::size_t);
template std::vector<float> fluctuation(FieldShape, std::span<const float>, std::size_t);

void add_overlap(FieldShape shape, std::span<const float> a, std::span<const float> b,
                 std::span<float> overlap) {
    const auto [bins, samples] = shape;
    for (std::size_t s = 0; s < bins; ++s) {
        float* __restrict c = &overlap[s * samples];
        for (std::size_t x = 0; x < bins; ++x) {
            const float* from = &a[x * samples];
            const float* to = &b[(x + s) % bins * samples];
            for (std::size_t r = 0; r < samples; ++r)
                c[r] += from[r] * to[r];
        }
    }
}

BestShift best_shift(FieldShape shape, std::span<const float> overlap, std::size_t sample,
                     std::size_t reach) {
    const std::size_t bins = shape.bins, samples = shape.samples;
    assert(sample < samples && reach >= 1 && 2 * reach < bins);
    const auto at = [&](std::size_t s) { return double{overlap[s % bins * samples + sample]}; };
    std::size_t best = 0;
    for (std::size_t s = 1; s < bins; ++s) {
        if (at(s) > at(best)) best = s;
    }
    // c = a + b k + d k^2 on k = -reach..reach; odd sums vanish.
    double n = 0, kk = 0, kkkk = 0, c = 0, kc = 0, kkc = 0;
    for (std::size_t i = 0; i <= 2 * reach; ++i) {
        const double k = static_cast<double>(i) - static_cast<double>(reach);
        const double value = at(best + bins + i - reach);
        n += 1;
        kk += k * k;
        kkkk += k * k * k * k;
        c += value;
        kc += k * value;
        kkc += k * k * value;
    }
    const double curvature = (n * kkc - kk * c) / (n * kkkk - kk * kk);
    const double limit = static_cast<double>(reach);
    const double offset = curvature < 0 ? std::clamp(-kc / kk / curvature / 2, -limit, limit) : 0.0;
    const auto length = static_cast<double>(bins);
    const double shift = static_cast<double>(best) + offset;
    return {best, shift > length / 2 ? shift - length : shift, at(best)};
}

std::vector<float> merge_overlapping(FieldShape shape, std::span<const float> a,
                                     std::span<const float> b) {
    const auto [bins, samples] = shape;
    std::vector<float> overlap(shape.size(), 0.0F), merged(shape.size());
    add_overlap(shape, a, b, overlap);
    for (std::size_t r = 0; r < samples; ++r) {
        const std::size_t shift = best_shift(shape, overlap, r).bins;
        for (std::size_t x = 0; x < bins; ++x) {
            merged[x * samples + r] =
                (a[x * samples + r] + b[(x + shift) % bins * samples + r]) / 2;
        }
    }
    return merged;
}

}  // namespace crossgrain::measure
