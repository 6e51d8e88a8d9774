// Contacts, plates, gravity and the kick-drift-kick of scheme_verlet.hpp in one pass over the
// grains: reads the records of one step, writes those of the next.
// A grain's force is summed in the order of its list, whatever the width of a vector. In double
// precision it is therefore the same on all instruction sets with the same reciprocal root; only
// the lid's push is summed in another order. In mixed precision the lid's push is a sum of
// integers.
#include "native/dem/simd_step.hpp"

#include <cstddef>
#include <cstdint>
#include <hwy/cache_control.h>
#include <type_traits>

// Older than any machine with a use for it; the scalar kernel does there.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "native/dem/simd_step.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, and in this order.
#include <hwy/highway.h>

#include "native/dem/simd_contacts-inl.hpp"
#include "native/dem/simd_lanes-inl.hpp"
#include "native/dem/simd_row_order-inl.hpp"
#include "native/dem/simd_survey-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace crossgrain::dem {
namespace HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR

enum class Ending { full_step, half_kick };

/// The lanes of the first n grains of a group.
template <class Format>
HWY_INLINE hn::Mask<typename Lanes<Format>::DP> FirstPlaces(std::size_t n) {
    using Position = typename Format::Position;
    const typename Lanes<Format>::DP d;
    const GroupShape shape{hn::Lanes(d), Lanes<Format>::blocks};
    Position places[hn::MaxLanes(d)];
    for (std::size_t lane = 0; lane < shape.lanes; ++lane)
        places[lane] = static_cast<Position>(shape.place_of_lane(lane));
    return hn::Lt(hn::LoadU(d, places), hn::Set(d, static_cast<Position>(n)));
}

/// Adds the plates' forces (plates.hpp), and the lid's overlaps to those of the block.
template <class Format>
HWY_INLINE void AddPlates(const StepTask<Format>& task, const StepConstants<Format>& c,
                          std::size_t group, typename Lanes<Format>::P y,
                          typename Lanes<Format>::V& fy) {
    using L = Lanes<Format>;
    const typename L::D d;
    const typename L::DP dp;
    const auto stiffness = hn::Set(d, c.plate_stiffness);
    const auto unit = hn::Set(d, c.unit_y);
    const auto length = [&](typename L::P overlap)
                            HWY_ATTR { return Separation<Format>(overlap, hn::Zero(dp), unit); };
    if (c.has_bottom) {
        const auto overlap = hn::Max(hn::Sub(hn::Set(dp, task.bottom), y), hn::Zero(dp));
        fy = hn::MulAdd(stiffness, length(overlap), fy);
    }
    if (c.has_lid) {
        auto overlap = hn::Max(hn::Sub(y, hn::Set(dp, task.lid)), hn::Zero(dp));
        const auto pushes = hn::Gt(overlap, hn::Zero(dp));
        if (hn::AllFalse(dp, pushes)) return;
        fy = hn::NegMulAdd(stiffness, length(overlap), fy);
        const std::size_t first = group * hn::Lanes(d);
        if (task.grains - first < hn::Lanes(d)) {
            overlap = hn::IfThenElseZero(FirstPlaces<Format>(task.grains - first), overlap);
        }
        task.lid_overlap[first / grains_per_block] +=
            static_cast<double>(hn::GetLane(hn::SumOfLanes(dp, overlap)));
    }
}

/// Whether contacts accelerate a grain by more than the task's limit.
template <class Format>
class AccelerationWatch {
    using D = typename Lanes<Format>::D;
    using V = typename Lanes<Format>::V;

  public:
    HWY_INLINE explicit AccelerationWatch(const StepTask<Format>& task)
        : task_(task), gravity_(hn::Set(D(), task.constants->gravity)),
          limit_(hn::Set(D(), task.acceleration_limit_squared)),
          within_(hn::Eq(hn::Zero(D()), hn::Zero(D()))) {}

    HWY_INLINE void Look(V ax, V ay) {
        const auto y = hn::Add(ay, gravity_);
        // Written so that what is no number is not within.
        within_ = hn::And(within_, hn::Le(hn::MulAdd(ax, ax, hn::Mul(y, y)), limit_));
    }
    HWY_INLINE void Tell() const {
        if (!hn::AllTrue(D(), within_)) *task_.exceeded = true;
    }

  private:
    const StepTask<Format>& task_;
    V gravity_, limit_;
    hn::Mask<D> within_;
};

/// Returns the number of rows that are looked at.
template <class Kind, bool crosses>
HWY_INLINE std::int64_t
AddRows(ContactForces<Kind>& forces, const StepTask<typename Kind::Format>& task,
        const std::uint32_t* HWY_RESTRICT row, const float* HWY_RESTRICT due) {
    using L = Lanes<typename Kind::Format>;
    const float step = task.step;
    // Ends before the first row that cannot touch yet.
    const float* const first = due;
    for (; *due <= step; ++due, row += hn::Lanes(typename L::D()))
        forces.template Add<crosses>(L::Neighbours::Load(task.in, row));
    return due - first;
}

/// Half a kick from `vx, vy`, the drift, and the velocities that the next dashpots see.
template <class Kind>
HWY_INLINE void KickAndDrift(
    const StepTask<typename Kind::Format>& task, const StepConstants<typename Kind::Format>& c,
    std::size_t first, Lanes<typename Kind::Format>& i, typename Lanes<typename Kind::Format>::V vx,
    typename Lanes<typename Kind::Format>::V vy, typename Lanes<typename Kind::Format>::V ax,
    typename Lanes<typename Kind::Format>::V ay, AccelerationWatch<typename Kind::Format>& watch) {
    using L = Lanes<typename Kind::Format>;
    const typename L::D d;
    const auto half = hn::Set(d, c.dt / 2);
    watch.Look(ax, ay);
    i.vx = hn::MulAdd(ax, half, vx);
    i.vy = hn::MulAdd(ay, half, vy);
    i.x = L::Drift(i.x, i.vx, hn::Set(d, c.steps_x));
    i.y = L::Drift(i.y, i.vy, hn::Set(d, c.steps_y));
    if constexpr (Kind::predicted) {
        hn::StoreU(i.vx, d, task.own_x + first);
        hn::StoreU(i.vy, d, task.own_y + first);
        i.vx = hn::MulAdd(ax, half, i.vx);
        i.vy = hn::MulAdd(ay, half, i.vy);
    }
}

template <class Kind>
void OpenStep(const StepTask<typename Kind::Format>& task) {
    using L = Lanes<typename Kind::Format>;
    const typename L::D d;
    AccelerationWatch<typename Kind::Format> watch(task);
    for (std::size_t group = task.first_group; group < task.last_group; ++group) {
        const std::size_t first = group * hn::Lanes(d);
        L i = L::LoadGroup(task.in + first);
        KickAndDrift<Kind>(task, *task.constants, first, i, i.vx, i.vy,
                           hn::LoadU(d, task.own_x + first), hn::LoadU(d, task.own_y + first),
                           watch);
        i.StoreGroup(task.out + first);
    }
    watch.Tell();
}

/// A window of the list is sorted by number of neighbours: the first to ask for its records ask in
/// no order that a processor foresees. Nor does it foresee which rows are due.
template <class Format>
HWY_INLINE void PrefetchGroup(const StepTask<Format>& task, std::size_t group) {
    constexpr std::size_t line = CacheLineAllocator<typename Format::Record>::bytes;
    constexpr std::size_t rows_likely_due = 3;
    const std::size_t lanes = hn::Lanes(typename Lanes<Format>::D());
    const auto* records = reinterpret_cast<const std::uint8_t*>(task.in + group * lanes);
    for (std::size_t offset = 0; offset < lanes * sizeof(*task.in); offset += line)
        hwy::Prefetch(records + offset);
    const std::size_t first_row = task.list->first_row[group];
    hwy::Prefetch(task.list->due.data() + first_row + group);
    const auto* rows =
        reinterpret_cast<const std::uint8_t*>(task.list->offsets.data() + first_row * lanes);
    for (std::size_t offset = 0; offset < rows_likely_due * lanes * sizeof(std::uint32_t);
         offset += line)
        hwy::Prefetch(rows + offset);
}

/// Forces on the groups of the task and what follows from them.
template <class Kind, Ending ending>
void ForceStep(const StepTask<typename Kind::Format>& given) {
    // Copies, which no store to a record can change: constants stay in registers.
    const StepTask<typename Kind::Format> task = given;
    const StepConstants<typename Kind::Format> c = *task.constants;
    using Format = typename Kind::Format;
    using L = Lanes<Format>;
    const typename L::D d;
    const std::size_t lanes = hn::Lanes(d);
    const auto inverse_mass = hn::Set(d, c.inverse_mass);
    const auto half = hn::Set(d, c.dt / 2);
    AccelerationWatch<Format> watch(task);
    ContactForces<Kind> forces(c);
    std::int64_t looked_at = 0;
    for (std::size_t group = task.first_group; group < task.last_group; ++group) {
        const std::size_t first = group * lanes;
        if (first + task.ahead < task.grains) PrefetchGroup(task, group + task.ahead / lanes);
        forces.Begin(task.in + first);
        const std::size_t first_row = task.list->first_row[group];
        const auto* row = task.list->offsets.data() + first_row * lanes;
        const auto* due = task.list->due.data() + first_row + group;
        if (std::is_same_v<Format, DoubleFormat> && task.list->crosses[group] != 0) {
            looked_at += AddRows<Kind, true>(forces, task, row, due);
        } else {
            looked_at += AddRows<Kind, false>(forces, task, row, due);
        }
        L i = forces.End(task.in + first);
        auto fy = forces.Y();
        AddPlates(task, c, group, i.y, fy);
        const auto ax = hn::Mul(forces.X(), inverse_mass);
        const auto ay = hn::MulSub(fy, inverse_mass, hn::Set(d, c.gravity));
        // v_{n+1}
        const auto vx =
            hn::MulAdd(ax, half, Kind::predicted ? hn::LoadU(d, task.own_x + first) : i.vx);
        const auto vy =
            hn::MulAdd(ay, half, Kind::predicted ? hn::LoadU(d, task.own_y + first) : i.vy);
        if constexpr (ending == Ending::full_step) {
            KickAndDrift<Kind>(task, c, first, i, vx, vy, ax, ay, watch);
        } else {
            hn::StoreU(ax, d, task.own_x + first);
            hn::StoreU(ay, d, task.own_y + first);
            i.vx = vx;
            i.vy = vy;
        }
        if (task.past_caches) {
            i.template StoreGroup<true>(task.out + first);
        } else {
            i.StoreGroup(task.out + first);
        }
    }
    if (task.past_caches) hwy::FlushStream();
    watch.Tell();
    *task.rows += looked_at;
}

template <class Kind>
StepFunctions<typename Kind::Format> FunctionsOf() {
    return {.group = {hn::Lanes(typename Lanes<typename Kind::Format>::D()),
                      Lanes<typename Kind::Format>::blocks},
            .instruction_set = hwy::TargetName(HWY_TARGET),
            .open = OpenStep<Kind>,
            .full = ForceStep<Kind, Ending::full_step>,
            .close = ForceStep<Kind, Ending::half_kick>,
            .order_rows = OrderRows<typename Kind::Format>,
            .survey = SurveyGroups<typename Kind::Format>};
}

template <class Format, DampingDirection damping, AttractiveTail tail>
StepFunctions<Format> WithScheme(const Parameters& p) {
    return p.scheme == Scheme::verlet_predicted
               ? FunctionsOf<Variant<Format, damping, tail, true>>()
               : FunctionsOf<Variant<Format, damping, tail, false>>();
}

template <class Format, DampingDirection damping>
StepFunctions<Format> WithTail(const Parameters& p) {
    switch (p.tail) {
    case AttractiveTail::kept:
        break;
    case AttractiveTail::contact_force_cut:
        return WithScheme<Format, damping, AttractiveTail::contact_force_cut>(p);
    case AttractiveTail::normal_force_cut:
        return WithScheme<Format, damping, AttractiveTail::normal_force_cut>(p);
    }
    return WithScheme<Format, damping, AttractiveTail::kept>(p);
}

template <class Format>
StepFunctions<Format> Functions(const Parameters& p) {
    return p.damping_direction == DampingDirection::full_vector
               ? WithTail<Format, DampingDirection::full_vector>(p)
               : WithTail<Format, DampingDirection::normal_only>(p);
}

#else

/// A machine without vectors of 128 bits: lanes = 0 says so.
template <class Format>
StepFunctions<Format> Functions(const Parameters&) {
    return {};
}

#endif  // HWY_TARGET != HWY_SCALAR

StepFunctions<MixedFormat> MixedFunctions(const Parameters& p) {
    return Functions<MixedFormat>(p);
}
StepFunctions<DoubleFormat> DoubleFunctions(const Parameters& p) {
    return Functions<DoubleFormat>(p);
}

}  // namespace HWY_NAMESPACE
}  // namespace crossgrain::dem
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace crossgrain::dem {

HWY_EXPORT(MixedFunctions);
HWY_EXPORT(DoubleFunctions);

StepFunctions<MixedFormat> mixed_step_functions(const Parameters& parameters) {
    return HWY_DYNAMIC_DISPATCH(MixedFunctions)(parameters);
}

StepFunctions<DoubleFormat> double_step_functions(const Parameters& parameters) {
    return HWY_DYNAMIC_DISPATCH(DoubleFunctions)(parameters);
}

}  // namespace crossgrain::dem
#endif
