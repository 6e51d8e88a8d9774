// A synthetic vibrated bed with one grain per cell and displacement fields of known spectrum, whose
// lid passes h0 at known times.
#pragma once

#include "cases/measure/bed/displacement_spectrum.hpp"
#include "cases/measure/bed/plate_motion.hpp"
#include "native/base/random.hpp"
#include "tests/cases/measure/synthetic_frame.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

namespace crossgrain::tests {

inline constexpr int cells = 64, layers = 20;
inline constexpr double d = 2, length = cells * d, period = 6, h0 = 40, swing = 3;
inline constexpr double cell_height = std::numbers::sqrt3 / 2 * d;
inline constexpr double pi = std::numbers::pi;

/// Displacement of the grain in cell X = 0..63 of layer Y = 1..20 by the n-th vector.
using Field = std::function<double(int n, int layer, int cell)>;

inline scene::Scene bed() {
    auto scene = plain_scene(cells * layers);
    scene.plates = {.stiffness = 1,
                    .touches = {},
                    .bottom =
                        scene::PrescribedPlate{.height = 0.5, .amplitude = 2, .period = period},
                    .lid = scene::FreeLid{.mass = 0.1}};
    scene.periodic_x = length;
    return scene;
}

/// Spacing h0 + swing sin(2 pi t/T): upwards through h0 at t = n T, downwards at (n + 1/2) T.
inline void set_lid(SyntheticFrame& frame, const scene::Scene& scene) {
    const double phase = 2 * pi * frame.time / period;
    const auto bottom = measure::plate_state(*scene.plates.bottom, frame.time);
    frame.lid = scene::LidState{bottom.height + h0 + swing * std::sin(phase),
                                bottom.velocity + swing * 2 * pi / period * std::cos(phase)};
}

/// One grain per cell, riding on the bottom; grains jump by `field` between the crossings. Frames
/// start half a period before the first crossing counted, at t = T or 3T/2, five per period, never
/// at a crossing.
inline measure::Results run(int vectors, const Field& field,
                            measure::DisplacementSpectrumOptions options,
                            const scene::Scene& scene = bed()) {
    options.spacing = options.spacing == 0 ? h0 : options.spacing;
    const bool upward = options.crossing != measure::Crossing::downward;
    const double first = upward ? 1.0 : 1.5, start = upward ? 0.4 : 0.8;
    measure::DisplacementSpectrum estimator(scene, options);
    std::vector<double> moved(static_cast<std::size_t>(cells * layers), 0.0);
    int jumps = 0;
    for (int f = 0;; ++f) {
        SyntheticFrame frame{.step = f, .time = period * (start + 0.2 * f)};
        if (frame.time > (vectors + first + 0.3) * period) break;
        // Half a period after the crossing that begins the vector.
        if (jumps < vectors && frame.time > (jumps + first + 0.5) * period) {
            for (int i = 0; i < cells * layers; ++i) {
                moved[static_cast<std::size_t>(i)] += field(jumps, i / cells + 1, i % cells);
            }
            ++jumps;
        }
        const auto bottom = measure::plate_state(*scene.plates.bottom, frame.time);
        for (int i = 0; i < cells * layers; ++i) {
            // Off the middle of the cell, to tell a cell from its half.
            const double x = d * (i % cells) + 0.3 + moved[static_cast<std::size_t>(i)];
            const double y = bottom.height + cell_height * (i / cells + 0.4);
            frame.add_grain(x, y, 0, bottom.velocity);
        }
        set_lid(frame, scene);
        estimator.add(frame.view());
    }
    measure::Results results;
    estimator.finish(results);
    return results;
}

// Displacements must not carry a grain out of its cell while vectors add up.
inline constexpr double small = 1e-5;

/// |FFT|^2 = (small)^2 K^exponent exactly, phases random.
inline Field exact_power_law(std::function<double(int layer)> exponent) {
    return [exponent](int n, int layer, int cell) {
        double sum = 0;
        for (int k = 1; k <= cells / 2; ++k) {
            const auto draw = static_cast<std::uint64_t>((n * 32 + layer) * 64 + k);
            const bool nyquist = k == cells / 2;
            const double phase = nyquist ? 0 : 2 * pi * uniform(1, RandomStream::jitter, draw);
            const double amplitude =
                small * std::pow(k, exponent(layer) / 2) * (nyquist ? 1.0 : 2.0) / cells;
            sum += amplitude * std::cos(2 * pi * k * cell / cells + phase);
        }
        return sum;
    };
}

/// Gaussian field with <S> = K^exponent: every realisation and layer its own amplitudes. The
/// transform is done once per (n, layer).
inline Field random_power_law(double exponent, std::uint64_t seed) {
    struct Row {
        int n = -1, layer = -1;
        std::vector<double> values = std::vector<double>(cells);
    };
    auto row = std::make_shared<Row>();
    static const std::vector<double> cosine = [] {
        std::vector<double> table;
        for (int i = 0; i < cells; ++i)
            table.push_back(std::cos(2 * pi * i / cells));
        return table;
    }();
    return [=](int n, int layer, int cell) {
        if (row->n != n || row->layer != layer) {
            std::ranges::fill(row->values, 0.0);
            row->n = n;
            row->layer = layer;
            for (int k = 1; k <= cells / 2; ++k) {
                const auto draw = static_cast<std::uint64_t>((n * 32 + layer) * 64 + k);
                const auto [a, b] = normal_pair(seed, RandomStream::jitter, draw);
                const double scale = small * std::pow(k, exponent / 2) / cells;
                for (int x = 0; x < cells; ++x) {
                    const auto c = static_cast<std::size_t>(k * x % cells);
                    const auto s = static_cast<std::size_t>((k * x + 3 * cells / 4) % cells);
                    row->values[static_cast<std::size_t>(x)] +=
                        k == cells / 2
                            ? scale * a * cosine[c]
                            : scale * std::numbers::sqrt2 * (a * cosine[c] + b * cosine[s]);
                }
            }
        }
        return row->values[static_cast<std::size_t>(cell)];
    };
}

}  // namespace crossgrain::tests
