// Coefficient of restitution and duration of collisions of isolated pairs, from the free flights
// before and after the contact.
//
// Relative motion r = x_{2k+1} - x_{2k}, v = dr/dt. Both free flights are extrapolated to the
// circle |r| = d, the mean of both diameters, which gives t_in, n_in = r_in/d and t_out, n_out =
// r_out/d without any error of sampling. Then (reduced units)
//   restitution              e   = -(v_out . n_out) / (v_in . n_in)
//   contact time             t_c = t_out - t_in
//   angular momentum ratio   (r_out x v_out) / (r_in x v_in)
//   speed ratio              |v_out| / |v_in|
// The normal turns during an oblique contact, hence n_in and n_out. For the head-on collision of
// Taguchi's Eq. (1) e = exp(-eta pi/omega) and t_c = pi/omega (Taguchi,
// chao-dyn/9405003 (1994), below Eq. 1). With damping of the full relative velocity
// dL/dt = -(eta/mu) L, so that the ratio is exp(-eta t_c/mu), mu the reduced mass: exp(-2 eta t_c)
// for two unit masses, exp(-eta t_c) against a frozen grain. With damping of the normal component
// only the force is central and the ratio is 1.
//
// Hypotheses: grains 2k and 2k+1 meet only each other, no gravity, no plates; the first frame is
// before and the last frame after the contact. A clipped contact may end its force while the grains
// still overlap: the flight is free from there on, so that the extrapolation holds.
#pragma once

#include "cases/measure/estimator.hpp"

#include <optional>
#include <vector>

namespace crossgrain::measure {

/// Measurements: `restitution` (1), `contact_time` (t), `speed_ratio` (1) and, unless a pair meets
/// head on (|b| < 1e-6 d, where it is 0/0), `angular_momentum_ratio` (1): means over the pairs with
/// their standard error (0 for a single pair); n is the number of pairs.
/// `complete_collisions`: number of pairs that came, touched and parted; n is the number of pairs.
///
/// Series "collisions", one row per pair: pair, restitution, contact_time, angular_momentum_ratio
/// (absent when a pair meets head on), speed_ratio, impact_parameter (b/d), approach_speed
/// (|v_in|).
///
/// A pair that touches already in the first frame, never touches, still touches in the last frame,
/// passed through the other grain, or kept its velocity, is not complete. With any such pair only
/// `complete_collisions` is reported. Nothing at all for scenes with gravity, plates, or an odd
/// number of grains.
class PairCollision final : public Estimator {
  public:
    explicit PairCollision(const scene::Scene& scene);
    void add(const scene::Frame& frame) override;
    void finish(Results& results) override;

  private:
    /// Relative position and velocity at a time.
    struct Flight {
        double time = 0;
        double x = 0, y = 0;
        double vx = 0, vy = 0;
    };
    struct Collision {
        double restitution = 0;
        double contact_time = 0;
        double angular_momentum_ratio = 0;
        double speed_ratio = 0;
        double impact_parameter = 0;
        double approach_speed = 0;
    };

    [[nodiscard]] std::vector<Flight> flights(const scene::Frame& frame) const;
    void choose_images(const scene::Frame& frame);
    /// Of two grains that touch at the distance d.
    [[nodiscard]] static std::optional<Collision> collision(const Flight& first, const Flight& last,
                                                            double d);
    static void add_complete(const std::vector<Collision>& complete, Results& results);

    bool applicable_ = false;
    std::size_t pairs_ = 0;
    std::vector<double> reach_;  ///< distance at which a pair touches, shape (pairs)
    std::optional<double> period_x_, period_y_;
    std::vector<double> shift_x_, shift_y_;  ///< to the image met, shape (pairs)
    std::vector<Flight> first_, last_;       ///< shape (pairs)
};

}  // namespace crossgrain::measure
