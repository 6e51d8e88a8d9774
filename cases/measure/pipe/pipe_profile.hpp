// Shape of the strongest density wave of grains in a pipe: fields are moved, whole bins, so that
// the phase of their strongest long wave (of k = 1 to 7, the same for the whole run) is the same,
// and averaged. Each of eight parts of the run gives one profile, errors are their scatter.
//
// The lattice gas has an ensemble of pipes and uses maximal overlap (gas_profile.hpp; Peng &
// Herrmann 1995, section III.B); of a few hundred grains that aligns the grains themselves, which
// stay together from field to field, and makes a sharp symmetric peak of anything. The phase aligns
// noise too: the same is done with bins shuffled at each instant.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"
#include "cases/measure/pipe/pipe_record.hpp"

#include <vector>

namespace crossgrain::measure {

struct PipeProfileOptions {
    PipeRecordOptions record;
};

inline OptionKeys option_keys(PipeProfileOptions& o) {
    return option_keys(o.record);
}

/// Measurements, n = 8: `profile_amplitude` (peak above the mean over the mean),
/// `profile_null_amplitude` (of shuffled bins), `profile_excess` (their difference),
/// `profile_asymmetry` (logarithm of the slope of the lower side, the front of what moves down,
/// over that of the upper side; 0 if symmetric), `profile_front_sharper` (share of the parts);
/// the last two only if every part has two sides. Series "profile": X (l, downward from the crest),
/// density over its mean, err, null. Nothing with fewer than 128 frames.
class PipeProfile final : public Estimator {
  public:
    using Options = PipeProfileOptions;
    /// Throws std::invalid_argument for a scene that is no pipe, a bin that is not > 0, or fewer
    /// than 16 bins.
    PipeProfile(const scene::Scene& scene, PipeProfileOptions options)
        : recorder_(scene, options.record) {}
    void add(const scene::Frame& frame) override { recorder_.add(frame); }
    void finish(Results& results) override;

  private:
    /// Density over its mean minus 1, shape (parts)(bins), the crest of the wave at bin bins/2.
    [[nodiscard]] std::vector<std::vector<double>> profiles(bool shuffled) const;

    PipeRecorder recorder_;
};

}  // namespace crossgrain::measure
