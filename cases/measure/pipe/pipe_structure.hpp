// Spatial spectrum S(k) of grains along a periodic pipe (structure_factor.hpp), from bins of one
// diameter, in which S(7) of a pipe of 220 is 0.3 % too low; eight parts of the run are the
// samples. Its exponent depends on a window, but not on the interval between frames, as the
// exponent in time does.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/pipe/pipe_record.hpp"
#include "cases/measure/waves/structure_factor.hpp"

#include <cstdint>

namespace crossgrain::measure {

struct PipeStructureOptions {
    double skip = 0;         ///< frames before this time (t) are left out
    std::int64_t k_min = 1;  ///< >= 1
    std::int64_t k_max = 7;  ///< > k_min, at most 64 and half the diameters in the pipe
};

/// What StructureFactor::append says, and `structure_factor` S(k_min), error by blocking, setting
/// k. Nothing with fewer than 128 frames.
class PipeStructure final : public Estimator {
  public:
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
