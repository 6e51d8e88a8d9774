// How far the grains have come since the neighbour list was made, and how fast they are.
// Included once per instruction set: no include guard but the one Highway asks for.
#if defined(CROSSGRAIN_DEM_SIMD_SURVEY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROSSGRAIN_DEM_SIMD_SURVEY_INL
#undef CROSSGRAIN_DEM_SIMD_SURVEY_INL
#else
#define CROSSGRAIN_DEM_SIMD_SURVEY_INL
#endif

#include "native/dem/simd_step.hpp"

#include <cstddef>

#include <hwy/highway.h>

#include "native/dem/simd_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace crossgrain::dem {
namespace HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR

/// Smallest and largest of all lanes seen.
template <class D>
class Extremes {
  public:
    HWY_INLINE explicit Extremes(hn::Vec<D> first) : low_(first), high_(first) {}
    HWY_INLINE void Look(hn::Vec<D> v) {
        low_ = hn::Min(low_, v);
        high_ = hn::Max(high_, v);
    }
    [[nodiscard]] HWY_INLINE Survey::Range Range() const {
        return {static_cast<double>(hn::GetLane(hn::MinOfLanes(D(), low_))),
                static_cast<double>(hn::GetLane(hn::MaxOfLanes(D(), high_)))};
    }

  private:
    hn::Vec<D> low_, high_;
};

template <class Format>
Survey SurveyGroups(const SurveyTask<Format>& task) {
    using L = Lanes<Format>;
    using D = typename L::D;
    const D d;
    const auto unit_x = hn::Set(d, task.constants->unit_x);
    const auto unit_y = hn::Set(d, task.constants->unit_y);
    const auto centre_x = hn::Set(d, task.centre_x);
    const auto centre_y = hn::Set(d, task.centre_y);
    const L first = L::LoadGroup(task.now + task.first_group * hn::Lanes(d));
    const L listed_first = L::LoadGroup(task.listed + task.first_group * hn::Lanes(d));
    Extremes<D> x(Separation<Format>(first.x, listed_first.x, unit_x));
    Extremes<D> y(Separation<Format>(first.y, listed_first.y, unit_y));
    Extremes<D> vx(first.vx), vy(first.vy), distance(hn::Zero(d));
    auto finite = hn::Eq(hn::Zero(d), hn::Zero(d));
    for (std::size_t group = task.first_group; group < task.last_group; ++group) {
        const L now = L::LoadGroup(task.now + group * hn::Lanes(d));
        const L listed = L::LoadGroup(task.listed + group * hn::Lanes(d));
        const auto dx = Separation<Format>(now.x, listed.x, unit_x);
        const auto dy = Separation<Format>(now.y, listed.y, unit_y);
        x.Look(dx);
        y.Look(dy);
        vx.Look(now.vx);
        vy.Look(now.vy);
        const auto off_x = hn::Sub(dx, centre_x);
        const auto off_y = hn::Sub(dy, centre_y);
        distance.Look(hn::MulAdd(off_x, off_x, hn::Mul(off_y, off_y)));
        // v - v is zero but for infinities and what is no number.
        const auto rest = hn::Add(hn::Sub(now.vx, now.vx), hn::Sub(now.vy, now.vy));
        finite = hn::And(finite, hn::Eq(rest, hn::Zero(d)));
    }
    return {.x = x.Range(),
            .y = y.Range(),
            .vx = vx.Range(),
            .vy = vy.Range(),
            .largest_distance_squared = distance.Range().high,
            .finite = hn::AllTrue(d, finite)};
}

#endif  // HWY_TARGET != HWY_SCALAR

}  // namespace HWY_NAMESPACE
}  // namespace crossgrain::dem
HWY_AFTER_NAMESPACE();

#endif
