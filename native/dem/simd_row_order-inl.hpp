// The rows of the neighbour list in the order in which their pairs can touch, from present
// positions and velocities. Most listed pairs will not touch for many steps to come: rows are left
// alone until they are due. Included once per instruction set: no include guard but the one Highway
// asks for.
#if defined(CROSSGRAIN_DEM_SIMD_ROW_ORDER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROSSGRAIN_DEM_SIMD_ROW_ORDER_INL
#undef CROSSGRAIN_DEM_SIMD_ROW_ORDER_INL
#else
#define CROSSGRAIN_DEM_SIMD_ROW_ORDER_INL
#endif

#include "native/dem/simd_step.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <hwy/highway.h>

#include "native/dem/simd_lanes-inl.hpp"
#include "native/dem/simd_reciprocal_root-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace crossgrain::dem {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

/// When pairs can touch. Two grains at a distance r that part at the speed u, both accelerated by
/// contacts by no more than A (gravity is the same for both), are after m drifts apart by at least
///   r + (m - s) u dt - A dt^2 (m + 1)^2,
/// where s = 1 if u > 0, and 0 otherwise: velocities are half a step from where they count. That is
/// a diameter at the earliest for m + 1 = M, the root of A dt^2 M^2 - u dt M = r - d - s u dt.
template <class Format>
class DueTimes {
    using L = Lanes<Format>;
    using D = typename L::D;
    using F = hn::Rebind<float, D>;
    using VF = hn::Vec<F>;

  public:
    HWY_INLINE explicit DueTimes(const RowOrderTask<Format>& task)
        : task_(task), unit_x_(Float(task.constants->unit_x)),
          unit_y_(Float(task.constants->unit_y)), dt_(Float(task.constants->dt)),
          reach_(Float(static_cast<double>(task.constants->diameter) * (1 + rounding_of_gaps))),
          four_a_(Float(4 * task.acceleration)),
          inverse_two_a_(Float(1 / (2 * task.acceleration))) {}

    /// M of all rows of a group, shape (rows, lanes).
    template <bool crosses>
    HWY_INLINE void Write(std::size_t group, std::size_t rows, float* HWY_RESTRICT due) const {
        const std::size_t lanes = hn::Lanes(D());
        const L i = L::LoadGroup(task_.now + group * lanes);
        const auto* offsets =
            task_.list->offsets.data() + std::size_t{task_.list->first_row[group]} * lanes;
        for (std::size_t row = 0; row < rows; ++row, offsets += lanes, due += lanes)
            hn::StoreU(Due<crosses>(i, L::Neighbours::Load(task_.now, offsets)), F(), due);
    }

  private:
    /// Of a diameter, far beyond the rounding of a float and of the coarsest reciprocal root.
    static constexpr double rounding_of_gaps = 1e-4;
    /// Likewise, of M.
    static constexpr float within_rounding = 0.999F;

    static HWY_INLINE VF Float(double value) { return hn::Set(F(), static_cast<float>(value)); }
    static HWY_INLINE VF ToFloat(hn::Vec<D> v) {
        if constexpr (std::is_same_v<typename Format::Real, float>) {
            return v;
        } else {
            return hn::DemoteTo(F(), v);
        }
    }

    template <bool crosses>
    [[nodiscard]] HWY_INLINE VF Due(const L& i, const typename L::Neighbours& j) const {
        const F f;
        auto offset_x = L::Difference(i.x, j.X());
        if constexpr (crosses) {
            const auto turns =
                hn::Round(hn::Mul(offset_x, hn::Set(D(), task_.constants->inverse_period)));
            offset_x = hn::NegMulAdd(turns, hn::Set(D(), task_.constants->period), offset_x);
        }
        const auto dx = hn::Mul(ToFloat(offset_x), unit_x_);
        const auto dy = hn::Mul(ToFloat(L::Difference(i.y, j.Y())), unit_y_);
        const auto dvx = ToFloat(hn::Sub(i.vx, j.Vx()));
        const auto dvy = ToFloat(hn::Sub(i.vy, j.Vy()));
        const auto r_squared = hn::MulAdd(dx, dx, hn::Mul(dy, dy));
        const auto inverse_r = ReciprocalRoot<F>(r_squared).Value();
        const auto parting =
            hn::Mul(hn::MulAdd(dvx, dx, hn::Mul(dvy, dy)), hn::Mul(inverse_r, dt_));
        const auto gap =
            hn::Sub(hn::MulSub(r_squared, inverse_r, reach_), hn::Max(parting, hn::Zero(f)));
        const auto discriminant = hn::MulAdd(four_a_, gap, hn::Mul(parting, parting));
        const auto root = hn::Mul(discriminant, ReciprocalRoot<F>(discriminant).Value());
        // The root of the quadratic that is no difference of nearly equal numbers.
        const auto sum = hn::Add(root, hn::Abs(parting));
        const auto parts = hn::Gt(parting, hn::Zero(f));
        const auto due =
            hn::IfThenElse(parts, hn::Mul(sum, inverse_two_a_), hn::Div(hn::Add(gap, gap), sum));
        return hn::IfThenElseZero(hn::Gt(gap, hn::Zero(f)),
                                  hn::Mul(due, hn::Set(f, within_rounding)));
    }

    const RowOrderTask<Format>& task_;
    VF unit_x_, unit_y_, dt_, reach_, four_a_, inverse_two_a_;
};

/// Sorts each lane: `due` and `offsets` have shape (rows, lanes), those that are due first come
/// first. What is due after the horizon stays in any order behind the others. Sets `first_due`,
/// shape (rows): the earliest in a row or behind it.
template <std::size_t lanes>
HWY_INLINE void OrderLanes(std::size_t rows, float horizon, float* HWY_RESTRICT due,
                           std::uint32_t* HWY_RESTRICT offsets, float* HWY_RESTRICT first_due) {
    const hn::CappedTag<float, lanes> d;
    const hn::RebindToUnsigned<decltype(d)> du;
    static_assert(hn::MaxLanes(d) == lanes);
    float first = 0;
    for (std::size_t top = 0; top < rows; ++top) {
        if (first <= horizon) {
            // The earliest of each lane rises from the last row to the top.
            auto least = hn::LoadU(d, due + (rows - 1) * lanes);
            auto whose = hn::LoadU(du, offsets + (rows - 1) * lanes);
            for (std::size_t row = rows - 1; row-- > top;) {
                const auto met = hn::LoadU(d, due + row * lanes);
                const auto whose_met = hn::LoadU(du, offsets + row * lanes);
                const auto passes = hn::RebindMask(du, hn::Lt(least, met));
                hn::StoreU(hn::Max(least, met), d, due + (row + 1) * lanes);
                hn::StoreU(hn::IfThenElse(passes, whose_met, whose), du,
                           offsets + (row + 1) * lanes);
                least = hn::Min(least, met);
                whose = hn::IfThenElse(passes, whose, whose_met);
            }
            hn::StoreU(least, d, due + top * lanes);
            hn::StoreU(whose, du, offsets + top * lanes);
            first = hn::GetLane(hn::MinOfLanes(d, least));
        }
        first_due[top] = first;
    }
}

template <class Format>
void OrderRows(const RowOrderTask<Format>& task) {
    constexpr std::size_t lanes = hn::MaxLanes(typename Lanes<Format>::D());
    const DueTimes<Format> due_times(task);
    PaddedList& list = *task.list;
    std::vector<float> due;
    for (std::size_t group = task.first_group; group < task.last_group; ++group) {
        const std::size_t first_row = list.first_row[group];
        const std::size_t rows = list.first_row[group + 1] - first_row;
        due.resize(std::max(due.size(), rows * lanes));
        if (std::is_same_v<Format, DoubleFormat> && list.crosses[group] != 0) {
            due_times.template Write<true>(group, rows, due.data());
        } else {
            due_times.template Write<false>(group, rows, due.data());
        }
        OrderLanes<lanes>(rows, task.horizon, due.data(), list.offsets.data() + first_row * lanes,
                          list.due.data() + first_row + group);
    }
}

#endif  // HWY_TARGET != HWY_SCALAR

}  // namespace HWY_NAMESPACE
}  // namespace crossgrain::dem
HWY_AFTER_NAMESPACE();

#endif
