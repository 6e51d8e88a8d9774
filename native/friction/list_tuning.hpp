// Chooses for how long a neighbour list is meant to last while the run goes on: margins are what
// grains travel in that time. Wide margins mean more pairs to look at in every step and, as a list
// grows old, touching pairs scattered over it; narrow ones mean more lists. All are counted, not
// timed, so that a run can be repeated bit by bit. Longer and shorter lists take turns, so that a
// flow that changes does not decide; then the time moves to the cheaper side.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace crossgrain::friction {

class ListTuning {
  public:
    explicit ListTuning(double time) : time_(time) {}

    /// What the next list is meant to last.
    [[nodiscard]] double time() const noexcept {
        return lists_ % 2 == 0 ? time_ * stride : time_ / stride;
    }

    /// A list of so many pairs per grain has been replaced after so many steps, in which the forces
    /// of so many pairs per grain were worked out, all steps together.
    void list_has_lasted(std::int64_t steps, double pairs_per_grain, double worked_out) {
        Side& side = sides_[lists_ % 2];
        side.steps += static_cast<double>(steps);
        side.cost += static_cast<double>(steps) * pairs_per_grain +
                     looks_worth_of_a_force * worked_out + looks_worth_of_a_list;
        if (++lists_ < lists_per_trial) return;
        const auto& [longer, shorter] = sides_;
        time_ *= longer.cost * shorter.steps < shorter.cost * longer.steps ? stride : 1 / stride;
        lists_ = 0;
        sides_ = {};
    }

  private:
    struct Side {
        double cost = 0, steps = 0;
    };
    /// Time to list the pairs of a grain, and for the force of a pair, over the time to look at one
    /// that does not touch. The optimum is flat.
    static constexpr double looks_worth_of_a_list = 150, looks_worth_of_a_force = 4;
    static constexpr double stride = 1.15;
    static constexpr std::size_t lists_per_trial = 12;

    double time_;
    std::array<Side, 2> sides_;  ///< of longer lists, of shorter ones
    std::size_t lists_ = 0;
};

}  // namespace crossgrain::friction
