#include "native/dem/row_order.hpp"

#include <algorithm>
#include <limits>

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "native/dem/row_order.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace crossgrain::dem {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Puts the nearer ones of two rows into the first of them. Returns whether any had to change.
template <std::size_t lanes>
HWY_INLINE bool OrderTwo(std::uint32_t* HWY_RESTRICT offsets, float* HWY_RESTRICT distances) {
    const hn::CappedTag<float, lanes> d;
    const hn::RebindToUnsigned<decltype(d)> du;
    bool changed = false;
    for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(d)) {
        const auto first = hn::LoadU(d, distances + lane);
        const auto second = hn::LoadU(d, distances + lanes + lane);
        const auto swap = hn::Lt(second, first);
        if (hn::AllFalse(d, swap)) continue;
        changed = true;
        hn::StoreU(hn::Min(first, second), d, distances + lane);
        hn::StoreU(hn::Max(first, second), d, distances + lanes + lane);
        const auto a = hn::LoadU(du, offsets + lane);
        const auto b = hn::LoadU(du, offsets + lanes + lane);
        const auto swap_u = hn::RebindMask(du, swap);
        hn::StoreU(hn::IfThenElse(swap_u, b, a), du, offsets + lane);
        hn::StoreU(hn::IfThenElse(swap_u, a, b), du, offsets + lanes + lane);
    }
    return changed;
}

/// Odd-even transposition sort of all lanes at once.
template <std::size_t lanes>
void OrderLanes(std::size_t rows, std::uint32_t* HWY_RESTRICT offsets,
                float* HWY_RESTRICT distances, float* HWY_RESTRICT nearest) {
    for (std::size_t pass = 0, quiet = 0; quiet < 2; ++pass) {
        bool changed = false;
        for (std::size_t row = pass % 2; row + 1 < rows; row += 2)
            changed |= OrderTwo<lanes>(offsets + row * lanes, distances + row * lanes);
        quiet = changed ? 0 : quiet + 1;
    }
    const hn::CappedTag<float, lanes> d;
    float behind = std::numeric_limits<float>::infinity();
    for (std::size_t row = rows; row-- > 0;) {
        for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(d)) {
            const auto all = hn::LoadU(d, distances + row * lanes + lane);
            behind = std::min(behind, hn::GetLane(hn::MinOfLanes(d, all)));
        }
        nearest[row] = behind;
    }
}

void Order(std::size_t rows, std::size_t lanes, std::uint32_t* offsets, float* distances,
           float* nearest) {
    switch (lanes) {
    case 2:
        return OrderLanes<2>(rows, offsets, distances, nearest);
    case 4:
        return OrderLanes<4>(rows, offsets, distances, nearest);
    case 8:
        return OrderLanes<8>(rows, offsets, distances, nearest);
    default:
        return OrderLanes<16>(rows, offsets, distances, nearest);
    }
}

OrderRows TheOrder() {
    return Order;
}

}  // namespace HWY_NAMESPACE
}  // namespace crossgrain::dem
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace crossgrain::dem {

HWY_EXPORT(TheOrder);

OrderRows order_rows_function() {
    return HWY_DYNAMIC_DISPATCH(TheOrder)();
}

}  // namespace crossgrain::dem
#endif
