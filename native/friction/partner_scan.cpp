#include "native/friction/partner_scan.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "native/friction/partner_scan.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, and in this order.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace crossgrain::friction {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// No fused operations: all instruction sets decide alike.
std::size_t Scan(const SortedDiscs& discs, const Seeker& seeker, std::size_t begin, std::size_t end,
                 std::uint32_t* found) {
    const hn::ScalableTag<double> d;
    const auto beyond = [&](double own, double own_margin, const std::vector<double>& others,
                            const std::vector<double>& margins, std::size_t q) HWY_ATTR {
        const auto distance = hn::Abs(hn::Sub(hn::Set(d, own), hn::LoadU(d, others.data() + q)));
        const auto margin = hn::Add(hn::Set(d, own_margin), hn::LoadU(d, margins.data() + q));
        return hn::Max(hn::Sub(distance, margin), hn::Zero(d));
    };
    const auto own_margin = hn::Set(d, seeker.margin);
    const auto own_place = hn::Set(d, static_cast<double>(seeker.place));
    const auto lane = hn::Iota(d, 0.0);  // some versions put it together in memory: only once
    std::size_t count = 0;
    for (std::size_t q = begin; q < end; q += hn::Lanes(d)) {
        const auto dx = beyond(seeker.x, seeker.margin_x, discs.x, discs.margin_x, q);
        const auto dy = beyond(seeker.y, seeker.margin_y, discs.y, discs.margin_y, q);
        const auto reach =
            hn::Add(hn::Set(d, seeker.radius), hn::LoadU(d, discs.radius.data() + q));
        const auto near = hn::Lt(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), hn::Mul(reach, reach));
        const auto margin = hn::LoadU(d, discs.margin.data() + q);
        const auto place = hn::Add(lane, hn::Set(d, static_cast<double>(q)));
        const auto earlier = hn::Lt(place, own_place);
        const auto mine =
            hn::Or(hn::Lt(margin, own_margin), hn::And(hn::Eq(margin, own_margin), earlier));
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, hn::And(near, hn::And(mine, hn::FirstN(d, end - q))), bits);
        for (unsigned left = bits[0]; left != 0; left &= left - 1)
            found[count++] = static_cast<std::uint32_t>(
                q + hwy::Num0BitsBelowLS1Bit_Nonzero32(static_cast<std::uint32_t>(left)));
    }
    return count;
}

ScanForPartners Function() {
    return Scan;
}

}  // namespace HWY_NAMESPACE
}  // namespace crossgrain::friction
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace crossgrain::friction {

HWY_EXPORT(Function);

ScanForPartners scan_for_partners_function() {
    return HWY_DYNAMIC_DISPATCH(Function)();
}

}  // namespace crossgrain::friction
#endif
