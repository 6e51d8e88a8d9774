// Velocity Verlet for many grains: vectors, threads, one pass per step. The order of things:
//   open    half a kick and the drift, from whole steps to the kernel's own rhythm
//   full    forces, two half kicks, drift; again and again
//   close   forces and half a kick: back to a whole step, so that the state can be looked at
// Positions are looked over after every drift and before the next forces. Frames change nothing:
// open and close round as full does.
#pragma once

#include "native/dem/kernel.hpp"
#include "native/dem/padded_list.hpp"
#include "native/dem/simd_coordinates.hpp"
#include "native/dem/simd_step.hpp"
#include "native/dem/skin_tuning.hpp"
#include "native/dem/thread_team.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace crossgrain::dem {

template <class Format>
class SimdKernel final : public StepKernel {
  public:
    SimdKernel(const Parameters& parameters, State initial, const StepFunctions<Format>& functions);

    void advance(std::int64_t steps) override;
    const State& state() override;
    [[nodiscard]] MissedContacts missed_contacts() const override { return {}; }
    [[nodiscard]] Effort effort() const override;

  private:
    using Real = typename Format::Real;
    using Record = typename Format::Record;
    using Function = typename StepFunctions<Format>::Function;

    void set_constants();
    void set_units();
    void run(Function function, Records<Format>& out);
    void push_lid(int kicks);
    void drift_lid();
    void look_over();
    void plan_survey(const Survey& s);
    [[nodiscard]] Survey survey();
    void make_list();
    void follow_grains();
    void check_grains() const;
    void wrap_grains();
    void sort_and_list();
    void write_records();
    [[nodiscard]] std::size_t groups() const { return padded_ / functions_.lanes; }

    Parameters p_;
    State state_;
    bool state_is_old_ = false;
    StepFunctions<Format> functions_;
    ThreadTeam team_;
    Coordinates<Format> coordinates_;
    StepConstants<Format> constants_;
    SkinTuning tuning_;

    std::size_t grains_, padded_;
    std::vector<std::uint32_t> number_;        ///< of the grain at a place, as it was given
    Records<Format> now_, next_, listed_;      ///< shape (padded + 1)
    std::vector<Real> own_x_, own_y_;          ///< shape (padded), see StepTask
    std::vector<double> listed_x_, listed_y_;  ///< when the list was made, x within the period
    std::vector<double> turns_;                ///< periods to add to x
    PaddedListMaker maker_;
    PaddedList list_;
    double lid_acceleration_ = 0;
    std::vector<double> lid_overlap_;

    bool exceeded_ = false;
    double skin_ = 0;  ///< of the present list
    Real drift_x_ = 0, drift_y_ = 0, speed_limit_ = 0;
    double centre_x_ = 0, centre_y_ = 0;
    std::int64_t steps_of_list_ = 0;
    std::int64_t steps_to_survey_ = 0, steps_since_survey_ = 0;
    std::int64_t evaluations_ = 0, builds_ = 0;
};

}  // namespace crossgrain::dem
