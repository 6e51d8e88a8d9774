// Velocity Verlet for many grains: vectors, threads, one pass per step. The order of things:
//   open    half a kick and the drift, from whole steps to the kernel's own rhythm
//   full    forces, two half kicks, drift; again and again
//   close   forces and half a kick: back to a whole step, so that the state can be looked at
// Positions are looked over after every drift and before the next forces, when it is time to: rows
// of the neighbour list are ordered by when they can touch, or the list is made anew. Frames change
// nothing: open and close round as full does.
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
    [[nodiscard]] std::int64_t steps_left(const Survey& s) const;
    [[nodiscard]] Survey survey();
    [[nodiscard]] double steps_worth_an_order() const;
    void order_rows(std::int64_t steps_left);
    void make_list();
    void follow_grains();
    void wrap(std::size_t place);
    [[nodiscard]] bool is_lost(std::size_t place) const;
    [[noreturn]] void tell_lost() const;
    void sort_and_list();
    void move_to(const std::vector<std::uint32_t>& order);
    void pad();
    [[nodiscard]] std::size_t groups() const { return padded_ / functions_.group.lanes; }

    Parameters p_;
    State state_;
    bool state_is_old_ = false;
    StepFunctions<Format> functions_;
    ThreadTeam team_;
    Coordinates<Format> coordinates_;
    StepConstants<Format> constants_;
    SkinTuning tuning_;

    /// What stands in the order of the list, beside the records.
    struct Places {
        std::vector<std::uint32_t> number;  ///< of the grain, as it was given
        std::vector<double> x, y;           ///< when the list was made, x within the period
        std::vector<double> turns;          ///< periods to add to x
        std::vector<Real> own_x, own_y;     ///< shape (padded), see StepTask
    };

    std::size_t grains_, padded_;
    Records<Format> now_, next_, listed_;  ///< shape (padded + 1)
    Places places_, spare_;
    PaddedListMaker maker_;
    PaddedList list_;
    double lid_acceleration_ = 0;
    std::vector<double> lid_overlap_;

    /// What a thread has to say of a step.
    struct alignas(64) Told {
        bool exceeded = false;
        std::int64_t rows = 0;
    };
    std::vector<Told> told_;  ///< shape (threads)

    double skin_ = 0;  ///< of the present list
    double least_acceleration_limit_;
    double acceleration_limit_;           ///< by contacts, on which the order of rows relies
    bool exceeded_ = false;               ///< that limit, in the last step
    double centre_x_ = 0, centre_y_ = 0;  ///< displacement since the list was made, where grains
                                          ///< are looked for
    std::int64_t horizon_ = 0;            ///< steps from one order of rows to the next
    std::int64_t steps_of_order_ = 0, steps_of_list_ = 0;
    std::int64_t orders_of_list_ = 0;
    std::int64_t rows_ = 0, rows_before_list_ = 0;  ///< looked at, and when the list was made
    std::int64_t evaluations_ = 0, builds_ = 0;
};

}  // namespace crossgrain::dem
