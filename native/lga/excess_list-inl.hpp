// Where collisions leave the rests beyond one per site, for relocation to find them.
#if defined(CROSSGRAIN_LGA_EXCESS_LIST_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROSSGRAIN_LGA_EXCESS_LIST_INL
#undef CROSSGRAIN_LGA_EXCESS_LIST_INL
#else
#define CROSSGRAIN_LGA_EXCESS_LIST_INL
#endif

#include "native/lga/aligned_words.hpp"
#include "native/lga/collision_plan.hpp"

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace crossgrain::lga::HWY_NAMESPACE {

template <std::size_t lanes>
class ExcessList {
  public:
    explicit ExcessList(int sites)
        : words_(aligned_words((static_cast<std::size_t>(sites) + 1) * excess_outputs * lanes)) {}

    /// Where the collision of the next site may write its excess rests, see collision_plan.hpp.
    [[nodiscard]] HWY_INLINE std::uint64_t* next() const { return words(sites_.size()); }
    /// It wrote some, at this site. Sites come in ascending order.
    HWY_INLINE void add(int site) { sites_.push_back(site); }

    [[nodiscard]] const std::vector<int>& sites() const noexcept { return sites_; }
    [[nodiscard]] HWY_INLINE std::uint64_t* words(std::size_t i) const {
        return words_.get() + i * excess_outputs * lanes;
    }
    void clear() { sites_.clear(); }

  private:
    AlignedWords words_;
    std::vector<int> sites_;
};

}  // namespace crossgrain::lga::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
