// A signal with a known answer, to calibrate estimators with: it comes as the frames of a gas.
#pragma once

#include "cases/scene/gas_sampling.hpp"

#include <cstdint>
#include <string>

namespace crossgrain::scene {

/// Bin counts n_i(t) = mean + noise + wave, rounded to whole particles.
/// Noise: Gaussian, power spectrum 1/f^exponent in every bin, bins independent (exponent 0: white).
/// Wave: amplitude cos(2 pi (x - velocity t) wave_number / L), added when amplitude > 0.
struct SyntheticSignal {
    std::string name;  ///< case and variant
    GasSampling sampling;
    double mean = 0;            ///< particles per bin, > 0, large enough to keep counts positive
    double noise = 0;           ///< standard deviation of the noise, > 0
    double exponent = 0;        ///< alpha, in [0, 2]
    double wave_amplitude = 0;  ///< particles per bin, >= 0
    double wave_velocity = 0;   ///< sites per step along gravity
    int wave_number = 1;        ///< waves per pipe length, >= 1
    std::uint64_t seed = 0;
};

}  // namespace crossgrain::scene
