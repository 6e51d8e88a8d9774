// Grains sorted by cell, pairs in batches, forces and motion with the vectors of this machine
// (simd_step.hpp).
#pragma once

#include "native/friction/contact_carrier.hpp"
#include "native/friction/kernel.hpp"
#include "native/friction/list_tuning.hpp"
#include "native/friction/pair_search.hpp"
#include "native/friction/simd_step.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace crossgrain::friction {

/// The numbers of the grains, in their present order: mobile ones, padding to an even number of
/// places, frozen ones, and one place that touches nobody. Shape of the vectors of 4: see
/// simd_step.hpp.
struct Places {
    AlignedVector<double> position, velocity;  ///< shape (places, 4)
    AlignedVector<double> own, torque;         ///< shape (places, 4)
    std::vector<double> radius, mass;          ///< shape (places)
    std::vector<std::uint32_t> grain;          ///< shape (places): as given; none: padding
};
constexpr std::uint32_t no_grain = 0xffffffff;

class SimdKernel final : public StepKernel {
  public:
    SimdKernel(const Parameters& parameters, State initial);

    void advance(std::int64_t steps) override;
    const State& state() override;
    [[nodiscard]] Effort effort() const override;

  private:
    void place_grains();
    void wrap();
    void set_margins();
    void list_pairs();
    void keep_contacts();
    void find_pairs();
    void reorder();
    void fill_list();
    void append(const NearPair& pair, bool near);
    void pad_list();
    [[nodiscard]] ContactMemory memory_of(std::size_t k) const;
    void remember(std::size_t k, const ContactMemory& memory);
    [[nodiscard]] MotionTask motion_task();
    void add_contact_forces(double spring_time);
    void relist_if_needed();
    [[nodiscard]] std::uint32_t place_of(std::uint32_t searched) const {
        return searched < mobile_ ? searched : searched + static_cast<std::uint32_t>(padding_);
    }

    Parameters p_;
    State s_;
    bool state_is_current_ = true;
    std::size_t mobile_ = 0, padding_ = 0, places_ = 0;
    double largest_radius_ = 0, widest_margin_ = 0;
    std::size_t memories_ = 0;  ///< arrays of memory in use
    StepFunctions functions_;
    PairSearch search_;
    ContactCarrier carrier_;
    ListTuning tuning_{0};
    Places now_, sorted_;
    AlignedVector<double> force_, listed_, margin_;             ///< shape (places, 4)
    std::vector<double> x_, y_, radius_, margin_x_, margin_y_;  ///< for the search
    PairList pairs_;
    std::vector<NearPair> far_;
    bool left_margin_ = false;
    std::int64_t evaluations_ = 0, builds_ = 0, listed_at_ = 0;
};

}  // namespace crossgrain::friction
