// Flux against density, bin by bin, and the speed dJ/drho of a kinematic wave
// (Lighthill & Whitham, Proc. R. Soc. A 229, 317 (1955)).
//
//   rho_i = n_i/(bin W),   J_i = (sum of downward velocities in bin i)/(bin W)
//
// J(rho) is the mean of J_i over all bins and frames of that density. dJ/drho at the mean density
// is the slope of the regression of J_i on rho_i over |rho_i - mean| <= window mean, done for each
// replica. Fluctuations that are not on the fundamental diagram (a bin in passing) tilt it: it is a
// regression slope, not a derivative of a steady state.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"
#include "cases/scene/gas_sampling.hpp"

#include <cstdint>
#include <vector>

namespace crossgrain::measure {

struct GasFluxOptions {
    double window = 0.5;
};

inline OptionKeys option_keys(GasFluxOptions& o) {
    return {{"window", &o.window, Range::left_open(0, 1),
             "half width of the regression, relative to the mean density"}};
}

/// Series "flux": rho, J, err, share (of all bins), in classes of 1/40 particle per site; classes
/// that only one replica visits are left out. Measurements, over replicas:
/// - `flux`: mean J, particles per site and step times sites;
/// - `mean_speed`: mean J over mean rho, sites per step (absent for an empty pipe);
/// - `particles_per_site`: mean rho; in a periodic pipe that of the scene, whatever happens, which
///   checks how bins, walls and width are counted;
/// - `flux_slope`: dJ/drho, sites per step, setting `window`; absent if fewer than half of the
///   replicas have two densities in the window (an error over the replicas that have).
class GasFlux final : public GasEstimator {
  public:
    using Options = GasFluxOptions;
    /// Throws std::invalid_argument for a window out of range or without `count` and `momentum`.
    GasFlux(const scene::GasSampling& sampling, GasFluxOptions options);
    void add(const scene::GasFrame& frame) override;
    void finish(Results& results) override;

  private:
    [[nodiscard]] std::vector<double> slopes() const;
    [[nodiscard]] Series curve() const;

    scene::GasSampling sampling_;
    GasFluxOptions options_;
    std::size_t replicas_, densities_;
    /// Bins seen with n particles and their summed momentum, shape (replicas, densities).
    std::vector<std::int64_t> seen_, momentum_;
};

}  // namespace crossgrain::measure
