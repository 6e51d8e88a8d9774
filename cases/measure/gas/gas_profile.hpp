// Shape of the strongest density wave by hierarchical maximal overlap
// (Peng & Herrmann 1995, section III.B, Fig. 4), in a periodic pipe.
//
// Successive fields are shifted in pairs until they overlap most and averaged; the averages are
// paired again, and so on until one profile is left for each replica. The profiles of the replicas
// of a group are then merged in the same way, and so are those of the groups. Errors are the
// scatter of the groups.
//
// Maximal overlap makes a peak of anything, of noise too. The same procedure is therefore done with
// fields whose bins are shuffled at each instant: the same particles per bin, no shape, no motion.
// A wave is worth the name as far as it stands above that peak.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"
#include "cases/measure/waves/field_shift.hpp"
#include "cases/scene/gas_sampling.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace crossgrain::measure {

struct GasProfileOptions {
    std::int64_t fields = 2048;
    std::int64_t groups = 16;
};

inline OptionKeys option_keys(GasProfileOptions& o) {
    return {{"fields", &o.fields, Range::whole(2), "frames used from the first on, a power of two"},
            {"groups", &o.groups, Range::whole(2),
             "of replicas, a power of two; replicas beyond a power of two per group are left out"}};
}

/// Series "profile" and the measurements of append_profile (wave_profile.hpp) over groups, in sites
/// and particles per site, and the full width at half maximum: `profile_width` (sites) and
/// `profile_width_over_length`.
/// Nothing if the run ended before the last field.
class GasProfile final : public GasEstimator {
  public:
    using Options = GasProfileOptions;
    /// Throws std::invalid_argument for an open pipe, without the field `count`, with fewer than
    /// eight bins, numbers that are no power of two, fewer frames than fields or fewer replicas
    /// than groups.
    GasProfile(const scene::GasSampling& sampling, GasProfileOptions options);
    void add(const scene::GasFrame& frame) override;
    void finish(Results& results) override;

  private:
    /// Averages of 2^k fields that wait for their partner, at index k.
    struct Ladder {
        std::vector<std::optional<std::vector<float>>> waiting;
        void add(FieldShape shape, std::vector<float> field);
    };
    [[nodiscard]] std::vector<float> groups_of(std::vector<float> profiles) const;
    [[nodiscard]] std::vector<std::vector<double>> aligned(const Ladder& ladder) const;

    scene::GasSampling sampling_;
    GasProfileOptions options_;
    FieldShape shape_;
    std::int64_t frame_ = 0;
    double mean_ = 0;  ///< particles per bin, all replicas and bins of the first frame
    Ladder fields_, shuffled_;
};

}  // namespace crossgrain::measure
