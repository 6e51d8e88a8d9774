// Density of grains in space and time as a picture in shades of grey, drawn like that of the
// lattice gas (gas_picture.hpp), beside which it is shown.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"
#include "cases/measure/pipe/pipe_record.hpp"

#include <cstdint>

namespace crossgrain::measure {

struct PipePictureOptions {
    PipeRecordOptions record{.bin = 2};
    std::int64_t rows = 500;
};

inline OptionKeys option_keys(PipePictureOptions& o) {
    return joined(option_keys(o.record), {{"rows", &o.rows, Range::whole(2, 2000),
                                           "most instants shown, equally spaced"}});
}

/// Picture "space-time": one pixel per bin from left to right (along gravity) and one row per
/// instant, time increasing upwards; white for the least and black for the greatest n_i.
class PipePicture final : public Estimator {
  public:
    using Options = PipePictureOptions;
    /// Throws std::invalid_argument for a scene that is no pipe or options out of range.
    PipePicture(const scene::Scene& scene, PipePictureOptions options);
    void add(const scene::Frame& frame) override { recorder_.add(frame); }
    void finish(Results& results) override;

  private:
    PipeRecorder recorder_;
    std::size_t rows_;
};

}  // namespace crossgrain::measure
