// Velocity of density waves of grains in a periodic pipe in three ways, and what can be compared
// with a lattice gas, which has other units: the velocity over that of the grains, V_w/V, and over
// the slope of its own flux-density curve, V_w/(dJ/drho), 1 for a kinematic wave (Lighthill &
// Whitham, Proc. R. Soc. A 229, 317 (1955)).
//
// For a pattern that travels without changing, J - V_w rho is constant by conservation of grains,
// and the local regression gives V_w whatever drives it. The test of the kinematic wave that can
// fail is the slope of the mean flux phi V over runs of different phi.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"
#include "cases/measure/pipe/pipe_modes.hpp"
#include "cases/measure/pipe/pipe_overlap.hpp"
#include "cases/measure/pipe/pipe_record.hpp"

namespace crossgrain::measure {

struct PipeWaveOptions {
    PipeRecordOptions record;
    PipeOverlapOptions overlap;
    double wavelength_min = 70;
};

inline OptionKeys option_keys(PipeWaveOptions& o) {
    return joined(joined(option_keys(o.record), option_keys(o.overlap)),
                  {{"wavelength_min", &o.wavelength_min, Range::positive(),
                    "of the regression, in diameters, at least four bins and at most L"}});
}

/// Measurements, velocities downward in l/t, errors by the jackknife over eight parts of the run:
/// - `overlap_wave_fraction`: share of the parts whose own shifts lie on a line;
/// - `overlap_velocity`; absent without a pattern or if the shifts of the whole run lie on no line;
/// - `wave_over_speed`: overlap_velocity/V; `wave_over_flux_slope`: overlap_velocity/(dJ/drho);
/// - `flux_slope`: dJ/drho, setting wavelength_min; only of a pattern: S(k) of those waves, on
///   average, is above 1 by a fifth and by three errors of its logarithm;
/// - `wave_velocity` by mode_spectrum.hpp over the whole run; absent without a peak, or if the
///   frames are too far apart (finding "sampling").
/// Finding "wave", by the 95 % interval of V_w/V: "carried" if it lies within 5 % of 1, a pattern
/// at rest among the grains; else "wave" if it does not hold 1; else "undecided"; "none" if nothing
/// travels. Series "overlap" and "flux".
/// Nothing with fewer than 128 frames.
class PipeWave final : public Estimator {
  public:
    using Options = PipeWaveOptions;
    /// Throws std::invalid_argument for a scene that is no pipe, and unless wavelength_min is from
    /// four bins to the length of the pipe; for what pipe_overlap refuses.
    PipeWave(const scene::Scene& scene, PipeWaveOptions options);
    void add(const scene::Frame& frame) override { recorder_.add(frame); }
    void finish(Results& results) override;

  private:
    void append_overlap(Results& results) const;
    void append_ratios(const OverlapVelocity& overlap,
                       const std::vector<FluxRegression>& regression, Results& results) const;

    PipeRecorder recorder_;
    PipeWaveOptions options_;
};

}  // namespace crossgrain::measure
