// Contacts, plates, gravity and the kick-drift-kick of scheme_verlet.hpp in one pass over the
// grains: reads the records of one step, writes those of the next.
// A grain's force is summed in the order of its list, whatever the width of a vector. In double
// precision it is therefore the same on all instruction sets with the same reciprocal root; only
// the lid's push is summed in another order. In mixed precision the lid's push is a sum of
// integers.
#include "native/dem/simd_step.hpp"

#include <cstddef>
#include <cstdint>
#include <type_traits>

// Older than any machine with a use for it; the scalar kernel does there.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "native/dem/simd_step.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, and in this order.
#include <hwy/highway.h>

#include "native/dem/simd_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace crossgrain::dem {
namespace HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR

enum class Ending { full_step, half_kick };

/// What a kernel is compiled for; everything else is data.
template <class TheFormat, DampingDirection the_damping, AttractiveTail the_tail, bool is_predicted>
struct Variant {
    using Format = TheFormat;
    static constexpr DampingDirection damping = the_damping;
    static constexpr AttractiveTail tail = the_tail;
    static constexpr bool predicted = is_predicted;
};

/// Taguchi's Eq. (1) and its variants (contact_law.hpp), added up over the neighbours of a group.
template <class Kind>
class ContactForces {
    using L = Lanes<typename Kind::Format>;
    using D = typename L::D;
    using V = typename L::V;

  public:
    HWY_INLINE ContactForces(const StepConstants<typename Kind::Format>& c, const L& grains)
        : i_(grains), diameter_(hn::Set(D(), c.diameter)),
          diameter_squared_(hn::Set(D(), c.diameter * c.diameter)),
          stiffness_(hn::Set(D(), c.stiffness)), damping_(hn::Set(D(), c.damping)),
          unit_x_(hn::Set(D(), c.unit_x)), unit_y_(hn::Set(D(), c.unit_y)),
          period_(hn::Set(D(), c.period)), inverse_period_(hn::Set(D(), c.inverse_period)),
          fx(hn::Zero(D())), fy(hn::Zero(D())) {}

    template <bool crosses>
    HWY_INLINE void Add(const L& j) {
        auto dx = L::Separation(i_.x, j.x, unit_x_);
        const auto dy = L::Separation(i_.y, j.y, unit_y_);
        if constexpr (crosses) {
            dx = hn::NegMulAdd(hn::Round(hn::Mul(dx, inverse_period_)), period_, dx);
        }
        const auto r_squared = hn::MulAdd(dx, dx, hn::Mul(dy, dy));
        const auto touch = hn::Lt(r_squared, diameter_squared_);
        // The outer rows of a list hardly ever touch.
        if (hn::AllFalse(D(), touch)) return;
        const auto inverse_r = ReciprocalRoot(D(), r_squared);
        // k (d - r)/r
        const auto spring = hn::Mul(stiffness_, hn::MulSub(diameter_, inverse_r, hn::Set(D(), 1)));
        const auto dvx = hn::Sub(i_.vx, j.vx);
        const auto dvy = hn::Sub(i_.vy, j.vy);
        if constexpr (Kind::damping == DampingDirection::full_vector &&
                      Kind::tail == AttractiveTail::kept) {
            AddWhere(touch, hn::MulSub(spring, dx, hn::Mul(damping_, dvx)),
                     hn::MulSub(spring, dy, hn::Mul(damping_, dvy)));
        } else {
            // (v.n)/r and F_n/r
            const auto approach =
                hn::Mul(hn::MulAdd(dvx, dx, hn::Mul(dvy, dy)), hn::Mul(inverse_r, inverse_r));
            auto normal = hn::NegMulAdd(damping_, approach, spring);
            auto acts = touch;
            if constexpr (Kind::tail == AttractiveTail::contact_force_cut) {
                acts = hn::And(touch, hn::Ge(normal, hn::Zero(D())));
            } else if constexpr (Kind::tail == AttractiveTail::normal_force_cut) {
                normal = hn::Max(normal, hn::Zero(D()));
            }
            if constexpr (Kind::damping == DampingDirection::normal_only) {
                AddWhere(acts, hn::Mul(normal, dx), hn::Mul(normal, dy));
            } else {
                const auto along_x = hn::NegMulAdd(approach, dx, dvx);
                const auto along_y = hn::NegMulAdd(approach, dy, dvy);
                AddWhere(acts, hn::MulSub(normal, dx, hn::Mul(damping_, along_x)),
                         hn::MulSub(normal, dy, hn::Mul(damping_, along_y)));
            }
        }
    }

  private:
    HWY_INLINE void AddWhere(hn::Mask<D> acts, V x, V y) {
        fx = hn::Add(fx, hn::IfThenElseZero(acts, x));
        fy = hn::Add(fy, hn::IfThenElseZero(acts, y));
    }

    L i_;
    V diameter_, diameter_squared_, stiffness_, damping_, unit_x_, unit_y_, period_,
        inverse_period_;

  public:
    V fx, fy;  ///< sums so far
};

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
                            HWY_ATTR { return L::Separation(overlap, hn::Zero(dp), unit); };
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
        overlap = hn::IfThenElseZero(hn::FirstN(dp, task.grains - first), overlap);
        task.lid_overlap[first / grains_per_block] +=
            static_cast<double>(hn::GetLane(hn::SumOfLanes(dp, overlap)));
    }
}

/// Whether a grain moves by more than the task's limit relative to the common drift.
template <class Format>
class SpeedWatch {
    using L = Lanes<Format>;
    using D = typename L::D;
    using V = typename L::V;

  public:
    HWY_INLINE explicit SpeedWatch(const StepTask<Format>& task)
        : task_(task), drift_x_(hn::Set(D(), task.drift_x)), drift_y_(hn::Set(D(), task.drift_y)),
          limit_(hn::Set(D(), task.speed_limit_squared)),
          within_(hn::Eq(hn::Zero(D()), hn::Zero(D()))) {}

    HWY_INLINE void Look(V vx, V vy) {
        const auto x = hn::Sub(vx, drift_x_);
        const auto y = hn::Sub(vy, drift_y_);
        // Written so that a speed that is no number is not within.
        within_ = hn::And(within_, hn::Le(hn::MulAdd(x, x, hn::Mul(y, y)), limit_));
    }
    HWY_INLINE void Tell() const {
        if (!hn::AllTrue(D(), within_)) *task_.exceeded = true;
    }

  private:
    const StepTask<Format>& task_;
    V drift_x_, drift_y_, limit_;
    hn::Mask<D> within_;
};

template <class Kind, bool crosses>
HWY_INLINE void
AddRows(ContactForces<Kind>& forces, const typename Kind::Format::Record* HWY_RESTRICT records,
        const std::uint32_t* HWY_RESTRICT row, const std::uint32_t* HWY_RESTRICT end) {
    using L = Lanes<typename Kind::Format>;
    for (; row != end; row += hn::Lanes(typename L::D()))
        forces.template Add<crosses>(L::Load(records, row));
}

/// Half a kick from `vx, vy`, the drift, and the velocities that the next dashpots see.
template <class Kind>
HWY_INLINE void KickAndDrift(const StepTask<typename Kind::Format>& task, std::size_t first,
                             Lanes<typename Kind::Format>& i,
                             typename Lanes<typename Kind::Format>::V vx,
                             typename Lanes<typename Kind::Format>::V vy,
                             typename Lanes<typename Kind::Format>::V ax,
                             typename Lanes<typename Kind::Format>::V ay,
                             SpeedWatch<typename Kind::Format>& watch) {
    using L = Lanes<typename Kind::Format>;
    const typename L::D d;
    const auto& c = *task.constants;
    const auto half = hn::Set(d, c.dt / 2);
    i.vx = hn::MulAdd(ax, half, vx);
    i.vy = hn::MulAdd(ay, half, vy);
    watch.Look(i.vx, i.vy);
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
    SpeedWatch<typename Kind::Format> watch(task);
    for (std::size_t group = task.first_group; group < task.last_group; ++group) {
        const std::size_t first = group * hn::Lanes(d);
        L i = L::LoadGroup(task.in + first);
        KickAndDrift<Kind>(task, first, i, i.vx, i.vy, hn::LoadU(d, task.own_x + first),
                           hn::LoadU(d, task.own_y + first), watch);
        i.StoreGroup(task.out + first);
    }
    watch.Tell();
}

/// Forces on the groups of the task and what follows from them.
template <class Kind, Ending ending>
void ForceStep(const StepTask<typename Kind::Format>& task) {
    using Format = typename Kind::Format;
    using L = Lanes<Format>;
    const typename L::D d;
    const std::size_t lanes = hn::Lanes(d);
    const auto& c = *task.constants;
    const auto inverse_mass = hn::Set(d, c.inverse_mass);
    const auto half = hn::Set(d, c.dt / 2);
    SpeedWatch<Format> watch(task);
    for (std::size_t group = task.first_group; group < task.last_group; ++group) {
        const std::size_t first = group * lanes;
        L i = L::LoadGroup(task.in + first);
        ContactForces<Kind> forces(c, i);
        const auto* row = task.list->offsets.data() + task.list->first_row[group] * lanes;
        const auto* end = task.list->offsets.data() + task.list->first_row[group + 1] * lanes;
        if (std::is_same_v<Format, DoubleFormat> && task.list->crosses[group] != 0) {
            AddRows<Kind, true>(forces, task.in, row, end);
        } else {
            AddRows<Kind, false>(forces, task.in, row, end);
        }
        AddPlates(task, c, group, i.y, forces.fy);
        const auto ax = hn::Mul(forces.fx, inverse_mass);
        const auto ay = hn::MulSub(forces.fy, inverse_mass, hn::Set(d, c.gravity));
        // v_{n+1}
        const auto vx =
            hn::MulAdd(ax, half, Kind::predicted ? hn::LoadU(d, task.own_x + first) : i.vx);
        const auto vy =
            hn::MulAdd(ay, half, Kind::predicted ? hn::LoadU(d, task.own_y + first) : i.vy);
        if constexpr (ending == Ending::full_step) {
            KickAndDrift<Kind>(task, first, i, vx, vy, ax, ay, watch);
        } else {
            hn::StoreU(ax, d, task.own_x + first);
            hn::StoreU(ay, d, task.own_y + first);
            i.vx = vx;
            i.vy = vy;
        }
        i.StoreGroup(task.out + first);
    }
    watch.Tell();
}

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
    Extremes<D> x(L::Separation(first.x, listed_first.x, unit_x));
    Extremes<D> y(L::Separation(first.y, listed_first.y, unit_y));
    Extremes<D> vx(first.vx), vy(first.vy), distance(hn::Zero(d));
    auto finite = hn::Eq(hn::Zero(d), hn::Zero(d));
    for (std::size_t group = task.first_group; group < task.last_group; ++group) {
        const L now = L::LoadGroup(task.now + group * hn::Lanes(d));
        const L listed = L::LoadGroup(task.listed + group * hn::Lanes(d));
        const auto dx = L::Separation(now.x, listed.x, unit_x);
        const auto dy = L::Separation(now.y, listed.y, unit_y);
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

template <class Kind>
StepFunctions<typename Kind::Format> FunctionsOf() {
    return {.lanes = hn::Lanes(typename Lanes<typename Kind::Format>::D()),
            .instruction_set = hwy::TargetName(HWY_TARGET),
            .open = OpenStep<Kind>,
            .full = ForceStep<Kind, Ending::full_step>,
            .close = ForceStep<Kind, Ending::half_kick>,
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
