// Whether the lattice a run starts from is still one: pairs that touch although they are no
// neighbours in it. With fixed neighbours such a pair passes through each other unnoticed, so that
// the run has lost its meaning; otherwise they are new contacts, and the grains have been exchanged
// (Taguchi, chao-dyn/9405003 (1994), section 3: "no granular flow is allowed at all").
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/scene/contact_search.hpp"

#include <set>
#include <utility>

namespace crossgrain::measure {

/// Measurements: `foreign_contacts`, number of different pairs that overlap in at least one frame
/// and were farther apart than 1.366 d (halfway between the first and the second shell) in the
/// first one; `lattice_kept_until` (t), time of the last frame before the first such contact, the
/// end of the run if there is none. Nothing without a frame.
class LatticeOrder final : public Estimator {
  public:
    explicit LatticeOrder(const scene::Scene& scene);
    void add(const scene::Frame& frame) override;
    void finish(Results& results) override;

  private:
    using Pair = std::pair<std::size_t, std::size_t>;

    scene::ContactSearch contacts_, neighbours_;
    bool started_ = false;
    std::set<Pair> lattice_pairs_, foreign_pairs_;
    double kept_until_ = 0;
};

}  // namespace crossgrain::measure
