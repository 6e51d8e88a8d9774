// The contact law for a vector of grains.
// Included once per instruction set: no include guard but the one Highway asks for.
#if defined(CROSSGRAIN_DEM_SIMD_CONTACTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROSSGRAIN_DEM_SIMD_CONTACTS_INL
#undef CROSSGRAIN_DEM_SIMD_CONTACTS_INL
#else
#define CROSSGRAIN_DEM_SIMD_CONTACTS_INL
#endif

#include "native/dem/simd_step.hpp"

#include <hwy/highway.h>

#include "native/dem/simd_lanes-inl.hpp"
#include "native/dem/simd_reciprocal_root-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace crossgrain::dem {
namespace HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR

/// What a kernel is compiled for; everything else is data.
template <class TheFormat, DampingDirection the_damping, AttractiveTail the_tail, bool is_predicted>
struct Variant {
    using Format = TheFormat;
    static constexpr DampingDirection damping = the_damping;
    static constexpr AttractiveTail tail = the_tail;
    static constexpr bool predicted = is_predicted;
};

/// Taguchi's Eq. (1) and its variants (contact_law.hpp), added up over the neighbours of a group.
/// Distances are in units of x, so that those of x need not be converted: d and k are instead.
template <class Kind>
class ContactForces {
    using L = Lanes<typename Kind::Format>;
    using D = typename L::D;
    using V = typename L::V;
    using Real = typename Kind::Format::Real;

  public:
    /// Eq. (1) as it stands: its damping adds up to eta (n v_i - sum of v_j) over n contacts, for
    /// which neither relative velocities nor their products are needed.
    static constexpr bool plain =
        Kind::damping == DampingDirection::full_vector && Kind::tail == AttractiveTail::kept;

    HWY_INLINE explicit ContactForces(const StepConstants<typename Kind::Format>& c)
        : diameter_(hn::Set(D(), c.diameter / c.unit_x)),
          diameter_squared_(hn::Mul(diameter_, diameter_)),
          stiffness_(hn::Set(D(), c.stiffness * c.unit_x)),
          stiffness_times_diameter_(hn::Mul(stiffness_, diameter_)),
          damping_(hn::Set(D(), c.damping)), aspect_(hn::Set(D(), c.unit_y / c.unit_x)),
          aspect_squared_(hn::Mul(aspect_, aspect_)), period_(c.period),
          inverse_period_(c.inverse_period) {}

    HWY_INLINE void Begin(const typename Kind::Format::Record* HWY_RESTRICT group) {
        i_.LoadPositions(group);
        if constexpr (!plain) i_.LoadVelocities(group);
        fx_ = fy_ = vx_of_others_ = vy_of_others_ = contacts_ = hn::Zero(D());
    }
    /// The grains of the group; X() and Y() are complete from here on.
    [[nodiscard]] HWY_INLINE const L& End(const typename Kind::Format::Record* HWY_RESTRICT group) {
        if constexpr (plain) {
            // Not held in registers while neighbours need them, nor spilled.
            HWY_FENCE;
            i_.LoadVelocities(group);
            fx_ = Damped(fx_, i_.vx, vx_of_others_);
            fy_ = Damped(L::InUnitsOfX(fy_, aspect_), i_.vy, vy_of_others_);
        }
        return i_;
    }

    template <bool crosses>
    HWY_INLINE void Add(const typename L::Neighbours& j) {
        auto dx = L::Difference(i_.x, j.X());
        const auto dy = L::Difference(i_.y, j.Y());
        if constexpr (crosses) {
            const auto turns = hn::Round(hn::Mul(dx, hn::Set(D(), inverse_period_)));
            dx = hn::NegMulAdd(turns, hn::Set(D(), period_), dx);
        }
        const auto r_squared = L::DistanceSquared(dx, dy, aspect_squared_);
        const auto touch = hn::Lt(r_squared, diameter_squared_);
        // The outer rows of a list hardly ever touch.
        if (hn::AllFalse(D(), touch)) return;
        const ReciprocalRoot<D> inverse_r(r_squared);
        // k (d - r)/r = k d/r - k
        const auto spring = inverse_r.TimesLess(stiffness_times_diameter_, stiffness_);
        if constexpr (plain) {
            const auto acting = hn::IfThenElseZero(touch, spring);
            fx_ = hn::MulAdd(acting, dx, fx_);
            fy_ = hn::MulAdd(acting, dy, fy_);
            const auto one = hn::IfThenElseZero(touch, hn::Set(D(), 1));
            vx_of_others_ = hn::MulAdd(one, j.Vx(), vx_of_others_);
            vy_of_others_ = hn::MulAdd(one, j.Vy(), vy_of_others_);
            contacts_ = hn::Add(contacts_, one);
        } else {
            const auto y = L::InUnitsOfX(dy, aspect_);
            const auto dvx = hn::Sub(i_.vx, j.Vx());
            const auto dvy = hn::Sub(i_.vy, j.Vy());
            // (v.n)/r and F_n/r
            const auto root = inverse_r.Value();
            const auto approach =
                hn::Mul(hn::MulAdd(dvx, dx, hn::Mul(dvy, y)), hn::Mul(root, root));
            auto normal = hn::NegMulAdd(damping_, approach, spring);
            auto acts = touch;
            if constexpr (Kind::tail == AttractiveTail::contact_force_cut) {
                acts = hn::And(touch, hn::Ge(normal, hn::Zero(D())));
            } else if constexpr (Kind::tail == AttractiveTail::normal_force_cut) {
                normal = hn::Max(normal, hn::Zero(D()));
            }
            if constexpr (Kind::damping == DampingDirection::normal_only) {
                AddWhere(acts, hn::Mul(normal, dx), hn::Mul(normal, y));
            } else {
                const auto along_x = hn::NegMulAdd(approach, dx, dvx);
                const auto along_y = hn::NegMulAdd(approach, y, dvy);
                AddWhere(acts, hn::MulSub(normal, dx, hn::Mul(damping_, along_x)),
                         hn::MulSub(normal, y, hn::Mul(damping_, along_y)));
            }
        }
    }

    [[nodiscard]] HWY_INLINE V X() const { return fx_; }
    [[nodiscard]] HWY_INLINE V Y() const { return fy_; }

  private:
    HWY_INLINE void AddWhere(hn::Mask<D> acts, V x, V y) {
        fx_ = hn::Add(fx_, hn::IfThenElseZero(acts, x));
        fy_ = hn::Add(fy_, hn::IfThenElseZero(acts, y));
    }
    [[nodiscard]] HWY_INLINE V Damped(V force, V own, V of_others) const {
        return hn::NegMulAdd(damping_, hn::MulSub(contacts_, own, of_others), force);
    }

    V diameter_, diameter_squared_, stiffness_, stiffness_times_diameter_, damping_;
    V aspect_, aspect_squared_;  ///< of the units of y and x
    Real period_, inverse_period_;
    L i_;
    V fx_, fy_;                                 ///< sums so far
    V vx_of_others_, vy_of_others_, contacts_;  ///< those that touch, likewise
};

#endif  // HWY_TARGET != HWY_SCALAR

}  // namespace HWY_NAMESPACE
}  // namespace crossgrain::dem
HWY_AFTER_NAMESPACE();

#endif
