// Energy balance of a run: what the plates put in, what the dashpots take out, what is stored.
//
//   E_tot = sum m v^2/2 + M V^2/2 + sum m g y + M g h
//         + sum_pairs k (d - r)^2/2 + sum_plates k_p overlap^2/2
//                                         (Taguchi, chao-dyn/9405003 (1994), Eqs. 12-14)
//   P_in  = sum over prescribed plates of (force of the plate on the grains) . (plate velocity)
//                                         (Eq. 15 as dt -> 0)
//   P_dis = sum over touching pairs of -(F - F_spring) . v_rel
//                                         (Eq. 16 as dt -> 0 for full-vector damping, no clipping)
//   residual = (E_in - E_dis - (E_tot(end) - E_tot(0))) / scale
// with E_in, E_dis the trapezoid sums of the powers over the frames, and scale = E_in for a driven
// scene, E_dis for an undriven dissipative one, and the largest kinetic + elastic energy otherwise.
//
// P_dis by variant, with overlap delta = d - r, normal and tangential parts v_n (> 0 when parting)
// and v_t of the relative velocity:
//   full vector  eta (v_n^2 + v_t^2);   normal only  eta v_n^2;
//   clipped (k delta < eta v_n)  k delta v_n, the spring energy that is given up, plus eta v_t^2
//   if the clipping keeps the tangential dashpot of full-vector damping.
//
// Sampling: P_dis jumps when a contact begins, so the trapezoid error is first order in the frame
// interval. The interval must not exceed t_col/10; `systematic` is the change of the residual when
// every second frame is left out.
#pragma once

#include "cases/measure/contact_search.hpp"
#include "cases/measure/estimator.hpp"

#include <vector>

namespace crossgrain::measure {

struct EnergyBalanceOptions {
    double skip = 0;  ///< time (t) left out of the averages at the start; the balance keeps it
};

/// Measurements: `energy_residual` (1), n is the number of frames, setting frames_per_contact_time;
/// and `mean_energy` (m l^2/t^2), `mean_energy_input` and `mean_dissipation` (m l^2/t^3; powers),
/// time means from t = skip on (time_mean.hpp; over whole periods if driven), n the number of
/// independent blocks, absent when the run is too short to tell their errors. Series "energy": t,
/// kinetic, gravity, elastic, input, dissipated (the last two cumulated).
///
/// Nothing if the frame interval exceeds t_col/10, if the pair is overdamped (it has no t_col), if
/// grains spin (the force is then not a function of the frame), or for fewer than three frames.
/// The lid's kinetic and gravitational energy are in `kinetic` and `gravity`; frozen grains count
/// as at rest.
class EnergyBalance final : public Estimator {
  public:
    explicit EnergyBalance(const scene::Scene& scene, EnergyBalanceOptions options = {});
    void add(const scene::Frame& frame) override;
    void finish(Results& results) override;

  private:
    struct Sample {
        double time = 0;
        double kinetic = 0, gravity = 0, elastic = 0;
        double input_power = 0, dissipated_power = 0;
        [[nodiscard]] double total() const noexcept { return kinetic + gravity + elastic; }
    };
    struct Balance {
        double input = 0, dissipated = 0;
        double change = 0;  ///< of E_tot
        [[nodiscard]] double residual() const noexcept { return input - dissipated - change; }
    };

    void add_motion(const scene::Frame& frame, Sample& sample) const;
    void add_pairs(const scene::Frame& frame, Sample& sample);
    void add_plates(const scene::Frame& frame, Sample& sample) const;
    [[nodiscard]] Balance integrate(std::size_t stride, std::size_t end) const;
    [[nodiscard]] double scale(const Balance& balance) const;
    void add_averages(Results& results) const;
    void add_series(Results& results) const;

    EnergyBalanceOptions options_;
    bool applicable_ = false;
    bool driven_ = false;
    double frames_per_contact_time_ = 0;
    scene::Grains grains_;
    scene::ContactLaw contact_;
    scene::Plates plates_;
    double gravity_ = 0;
    std::vector<bool> frozen_;  ///< empty when no grain is frozen
    ContactSearch contacts_;
    std::vector<Sample> samples_;  ///< shape (frames): powers and energies, no trajectory
};

}  // namespace crossgrain::measure
