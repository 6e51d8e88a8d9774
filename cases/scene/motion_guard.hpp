// Whether a trajectory can be that of its scene: a program may have read another state, written
// velocities of another time, wrapped or swapped its grains, or taken steps that the contacts do
// not survive, and still end without an error.
#pragma once

#include "cases/scene/contact_search.hpp"
#include "cases/scene/frame.hpp"
#include "cases/scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace crossgrain::scene {

/// Holds every frame against the scene and against the two before it:
///   the first against the initial state, to 1e-9 of a diameter and of the largest velocity (1e-6
///     in mixed precision);
///   how far a grain or the lid has come, against what the velocities in the system allow;
///   free flight (only gravity between two frames, by the velocities or by three positions): the
///     displacement is dt times the mean velocity;
///   velocities, no larger than the contacts can stop within half a diameter;
///   overlaps of grains, at most half of the smaller diameter;
///   where no plate is driven: kinetic, elastic and potential energy together may rise by half of
///     the largest kinetic energy seen so far, which no integrator does that is of any use.
class MotionGuard {
  public:
    explicit MotionGuard(const Scene& scene);

    /// The next frame, of the scene's number of grains, finite. Throws TrajectoryError with the
    /// grain, the step and both numbers, or at the first frame if the scene's time step resolves
    /// not all of its contacts (step_resolution.hpp).
    void check(const Frame& frame);

  private:
    /// What moves: the grains, then the lid. All of shape (grains + lid).
    struct State {
        std::vector<double> x, y, vx, vy;
        double fastest = 0;  ///< speed
    };

    [[nodiscard]] State state_of(const Frame& frame) const;
    void check_start(const Frame& frame) const;
    void check_jumps(const State& now, std::int64_t step) const;
    void check_flights(const State& now, std::int64_t step);
    [[nodiscard]] bool flew_by_velocities(const State& now, std::size_t i) const;
    [[nodiscard]] bool flew_by_positions(const State& now, std::size_t i) const;
    void check_speeds(const Frame& frame) const;
    void check_overlaps_and_energy(const Frame& frame);
    [[nodiscard]] double kinetic_and_potential(const Frame& frame, double& kinetic) const;
    [[nodiscard]] double elastic_at_plates(const Frame& frame) const;
    [[nodiscard]] std::string name_of(std::size_t i) const;
    [[nodiscard]] bool is_frozen(std::size_t i) const;

    const Scene& scene_;
    double tolerance_;    ///< of what is told, relative
    double interval_;     ///< of frames (t)
    double plate_speed_;  ///< largest of the driven plates
    ContactSearch contacts_;
    State last_, last_but_one_;
    std::int64_t frames_ = 0;
    /// Of grains, and of the lid.
    struct Flights {
        std::int64_t all = 0, wrong = 0;
    };
    Flights of_grains_, of_lid_;
    double first_energy_ = 0, largest_kinetic_ = 0;
};

}  // namespace crossgrain::scene
