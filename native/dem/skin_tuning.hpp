// Chooses the skin of the neighbour list while the run goes on. A wide skin means more pairs to
// look at in every step, a narrow one more lists. Both are counted, not timed, so that a run can be
// repeated bit by bit:
//   cost per step = rows looked at per group + (cost of a list + orders of its rows) / its steps.
// The skin climbs down that cost in steps of 12 %, and turns round whenever the cost rises.
#pragma once

#include <algorithm>
#include <cstdint>

namespace crossgrain::dem {

class SkinTuning {
  public:
    /// Lengths, 0 < narrowest <= start <= widest.
    SkinTuning(double start, double narrowest, double widest)
        : skin_(std::clamp(start, narrowest, widest)), narrowest_(narrowest), widest_(widest) {}

    [[nodiscard]] double skin() const noexcept { return skin_; }

    /// A list has been replaced after so many steps, in which its rows have been put in order so
    /// often, and so many of them per group have been looked at.
    void list_has_lasted(std::int64_t steps, std::int64_t orders, double rows_per_group) {
        steps_ += steps;
        cost_ += rows_per_group + rows_worth_of_a_list +
                 rows_worth_of_an_order * static_cast<double>(orders);
        if (++lists_ < lists_per_trial) return;
        const double cost = cost_ / static_cast<double>(std::max<std::int64_t>(steps_, 1));
        if (last_cost_ > 0 && cost > last_cost_) factor_ = 1 / factor_;
        last_cost_ = cost;
        skin_ = std::clamp(skin_ * factor_, narrowest_, widest_);
        lists_ = 0;
        steps_ = 0;
        cost_ = 0;
    }

  private:
    /// Time to sort and list a group over the time for one row of its forces; between 120 and 250
    /// with AVX-512 and AVX2. The optimum is flat.
    static constexpr double rows_worth_of_a_list = 160;
    /// Likewise for an order of its rows.
    static constexpr double rows_worth_of_an_order = 15;
    /// About a period of a shaken bed: the cost of a part of it says little.
    static constexpr int lists_per_trial = 24;

    double skin_, narrowest_, widest_;
    double factor_ = 1.12;
    double cost_ = 0, last_cost_ = 0;
    std::int64_t steps_ = 0;
    int lists_ = 0;
};

}  // namespace crossgrain::dem
