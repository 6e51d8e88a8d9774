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
// Sampling: P_dis jumps when a contact begins, so the trapezoid error of one contact is first order
// in the sampling interval; over many contacts it averages out and leaves a second order from the
// kinks. The frame interval must not exceed t_col/10. Between frames the motion can be interpolated
// (cubic Hermite) and the powers sampled `samples_per_frame` times, so that the residual is that of
// the scheme and not of the sum. `systematic` is the change of the residual when every second
// sample is left out.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"
#include "cases/scene/contact_search.hpp"

#include <optional>
#include <vector>

namespace crossgrain::measure {

struct EnergyBalanceOptions {
    double skip = 0;
    int samples_per_frame = 1;
    /// Below it nothing is measured, unless `accurate_within` asks what happens at long steps too.
    double least_frames_per_contact_time = 10;
    std::optional<double> accurate_within = {};
};

inline OptionKeys option_keys(EnergyBalanceOptions& o) {
    return {{"skip", &o.skip, Range::not_negative(),
             "time (t) left out of the averages at the start; the balance keeps it"},
            {"samples_per_frame", &o.samples_per_frame, Range::whole(1, 1'000'000),
             "of the powers, interpolated between frames"},
            {"accurate_within", &o.accurate_within, Range::positive(),
             "largest |energy_residual| of a run that is called accurate; left out: none is"}};
}

/// "ok" within the limit, "energy gain" beyond it below zero, else "inaccurate": energy is lost.
[[nodiscard]] std::string energy_state(double residual, double accurate_within);

/// Measurements: `energy_residual` (1), one number per run, setting samples_per_contact_time;
/// and `mean_energy` (m l^2/t^2), `mean_energy_input` and `mean_dissipation` (m l^2/t^3; powers),
/// time means from t = skip on (time_mean.hpp; over whole periods if driven), n the number of
/// independent blocks, absent when the run is too short to tell their errors. Under a bottom that
/// moves and gravity, with a period along x, also
///   energy_above_ground  mean_energy less that of the bed at rest in the closest packing on the
///                        bottom's mean height, grains and plates rigid: rows of L = L_h/d grains
///                        sqrt(3)/2 d apart, a free lid on the highest (m l^2/t^2)
///   input_per_period     mean_energy_input times the period (m l^2/t^2)
///   energy_per_input     the ratio of the two (1): about 1 by Taguchi's section 4
/// Finding "state", if asked for: energy_state().
/// Series "energy": t, kinetic, gravity, elastic, input, dissipated (the last two cumulated), at
/// most 2000 rows.
///
/// Throws std::invalid_argument for an option out of range. Nothing if the frame interval
/// exceeds t_col/10, if the pair is overdamped (it has no t_col), if grains spin (the force is then
/// not a function of the frame), or for fewer than three frames. The lid's kinetic and
/// gravitational energy are in `kinetic` and `gravity`; frozen grains count as at rest.
class EnergyBalance final : public Estimator {
  public:
    using Options = EnergyBalanceOptions;
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

    /// What is kept of a frame to interpolate. Arrays have shape (grains).
    struct Instant {
        double time = 0;
        std::vector<double> x, y, vx, vy;
        std::optional<scene::LidState> lid;
    };

    void store(const scene::Frame& frame, Instant& instant) const;
    void add_between(const Instant& a, const scene::Frame& b);
    [[nodiscard]] Sample sample(const scene::Frame& frame);
    void add_motion(const scene::Frame& frame, Sample& sample) const;
    void add_pairs(const scene::Frame& frame, Sample& sample);
    void add_plates(const scene::Frame& frame, Sample& sample) const;
    [[nodiscard]] Balance integrate(std::size_t stride, std::size_t end) const;
    [[nodiscard]] double scale(const Balance& balance) const;
    void add_averages(Results& results) const;
    void add_comparison_with_input(const Measurement& energy, const Measurement& input,
                                   Results& results) const;
    [[nodiscard]] std::optional<double> ground_energy() const;
    void add_series(Results& results) const;

    EnergyBalanceOptions options_;
    bool applicable_ = false;
    bool driven_ = false;
    double samples_per_contact_time_ = 0;
    scene::Grains grains_;
    scene::ContactLaw contact_;
    scene::Plates plates_;
    double gravity_ = 0;
    std::size_t grain_count_ = 0;
    std::optional<double> period_x_;
    std::vector<bool> frozen_;  ///< empty when no grain is frozen
    scene::ContactSearch contacts_;
    std::optional<Instant> previous_;  ///< frame, if samples between frames are asked for
    Instant between_;
    std::vector<Sample> samples_;  ///< shape (samples): powers and energies, no trajectory
};

}  // namespace crossgrain::measure
