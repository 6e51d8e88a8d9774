// Shape of a density wave, of particles and of grains alike: profiles of parts of a record, moved
// onto each other, beside those of shuffled bins, which show what the moving alone makes of noise.
#pragma once

#include "cases/measure/results.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace crossgrain::measure {

/// Wave shape of a profile, shape (bins).
struct WaveShape {
    double amplitude = 0;  ///< greatest density above the mean
    double width = 0;      ///< full width at half of it, bins
    double steepness = 0;  ///< slope of the front over that of the back, each between 25 and 75 %
};

/// `profile` is the density minus its mean, the wave moving towards larger indices. Nothing for a
/// flat profile or one that falls to 25 % of its height on neither side within the pipe.
[[nodiscard]] std::optional<WaveShape> wave_shape(const std::vector<double>& profile);

/// Profiles of parts, shape (parts)(bins): density over its mean, minus 1, the crest in bin bins/2.
struct AlignedProfiles {
    std::vector<std::vector<double>> waves;
    std::vector<std::vector<double>> nulls;  ///< of shuffled bins
};

/// What the axes of a profile are in.
struct ProfileScale {
    double bin = 1;      ///< length of a bin
    double density = 1;  ///< the mean
    std::string length_unit, density_unit;
};

/// Series "profile": X (0 at the crest), density, its standard error over the parts, null.
[[nodiscard]] Series profile_series(const AlignedProfiles& profiles, const ProfileScale& scale);

/// Appends, over the parts:
/// - `profile_amplitude`: crest above the mean over the mean;
/// - `profile_null_amplitude`: the same of the shuffled bins;
/// - `profile_excess`: amplitude minus null amplitude;
/// and, if every part has a shape:
/// - `profile_asymmetry`: logarithm of the slope of the front over that of the back; 0 if symmetric
///   (the ratio itself, with noise, has a mean above 1);
/// - `profile_front_sharper`: share of the parts whose front is steeper than their back.
/// Returns the shapes, shape (parts); fewer when parts have none.
std::vector<WaveShape> append_profile(const AlignedProfiles& profiles, Results& results);

}  // namespace crossgrain::measure
