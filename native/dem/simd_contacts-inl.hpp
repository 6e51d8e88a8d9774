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

#endif  // HWY_TARGET != HWY_SCALAR

}  // namespace HWY_NAMESPACE
}  // namespace crossgrain::dem
HWY_AFTER_NAMESPACE();

#endif
