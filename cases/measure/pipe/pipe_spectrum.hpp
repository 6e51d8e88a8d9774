// Exponent in time of the density fluctuations of grains in the bins of a pipe, P(f) ~ f^-alpha
// (bin_spectrum.hpp), the segments of one run the samples.
//
// Grains have no largest velocity as a lattice gas has, so the window is set by the flow itself:
// from 1.5 times the frequency f_w = k V_w/L of the wave, V_w that of pipe_modes.hpp and k the mode
// with the most power, to 0.35 V/b, above which a bin of width b sees single grains pass. Between,
// alpha still depends on b: it can be compared to +-0.3, in the same window. Without a wave
// f_w = V/L.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"
#include "cases/measure/pipe/pipe_record.hpp"
#include "cases/measure/waves/bin_spectrum.hpp"

#include <cstdint>

namespace crossgrain::measure {

struct PipeSpectrumOptions {
    PipeRecordOptions record;
    std::int64_t segments = 4;
    double low = 1.5;
    double high = 0.35;
};

inline OptionKeys option_keys(PipeSpectrumOptions& o) {
    return joined(option_keys(o.record),
                  {{"segments", &o.segments, Range::whole(2), "of the series"},
                   {"low", &o.low, Range::positive(), "start of the fit window, of the wave's f_w"},
                   {"high", &o.high, Range::left_open(0, 0.5), "end of that window, of V/b"}});
}

/// Measurement `alpha`, settings f_min, f_max (1/t), decades, peak (f_w, 1/t; 0 without a wave),
/// bin. Series "spectrum": f (1/t), P (t), err.
/// No alpha if the window is narrower than half a decade. Nothing but the finding "sampling" if
/// the frames are too far apart; nothing with fewer than 128 frames per segment.
class PipeSpectrum final : public Estimator {
  public:
    using Options = PipeSpectrumOptions;
    /// Throws std::invalid_argument for a scene that is no pipe, and unless segments >= 2, low > 0
    /// and 0 < high <= 0.5.
    PipeSpectrum(const scene::Scene& scene, PipeSpectrumOptions options);
    void add(const scene::Frame& frame) override { recorder_.add(frame); }
    void finish(Results& results) override;

  private:
    void append_alpha(const BinSpectrum& spectrum, Results& results) const;

    PipeRecorder recorder_;
    PipeSpectrumOptions options_;
};

}  // namespace crossgrain::measure
