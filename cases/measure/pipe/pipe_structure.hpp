// Spatial spectrum S(k) of grains along a periodic pipe (structure_factor.hpp), from bins of one
// diameter, in which S(7) of a pipe of 220 is 0.3 % too low; eight parts of the run are the
// samples. Its exponent depends on a window, but not on the interval between frames, as the
// exponent in time does.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"
#include "cases/measure/pipe/pipe_record.hpp"
#include "cases/measure/waves/structure_factor.hpp"

#include <cstdint>

namespace crossgrain::measure {

struct PipeStructureOptions {
    double skip = 0;
    std::int64_t k_min = 1;
    std::int64_t k_max = 7;  ///< at most half the diameters in the pipe
};

inline OptionKeys option_keys(PipeStructureOptions& o) {
    return {{"skip", &o.skip, Range::not_negative(), "frames before this time (t) are left out"},
            {"k_min", &o.k_min, Range::whole(1, 64), "first k of the fit window"},
            {"k_max", &o.k_max, Range::whole(1, 64), "last k of that window, > k_min"}};
}

/// What StructureFactor::append says, and `structure_factor` S(k_min), error by blocking, setting
/// k. Nothing with fewer than 128 frames.
class PipeStructure final : public Estimator {
  public:
    using Options = PipeStructureOptions;
    /// Throws std::invalid_argument for a scene that is no pipe or shorter than 16 diameters, and
    /// unless 1 <= k_min < k_max <= 64.
    PipeStructure(const scene::Scene& scene, PipeStructureOptions options);
    void add(const scene::Frame& frame) override { recorder_.add(frame); }
    void finish(Results& results) override;

  private:
    PipeRecorder recorder_;
    PipeStructureOptions options_;
    StructureFactor factor_;
};

}  // namespace crossgrain::measure
