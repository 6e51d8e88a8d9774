// Motion of the grains between two evaluations of the forces, whole grains per vector.
// Included once per instruction set: no include guard but the one Highway asks for.
#if defined(CROSSGRAIN_FRICTION_SIMD_MOTION_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROSSGRAIN_FRICTION_SIMD_MOTION_INL
#undef CROSSGRAIN_FRICTION_SIMD_MOTION_INL
#else
#define CROSSGRAIN_FRICTION_SIMD_MOTION_INL
#endif

#include "native/friction/simd_step.hpp"

#include <cstddef>

#include <hwy/highway.h>

#include "native/friction/simd_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace crossgrain::friction {
namespace HWY_NAMESPACE {

#if HWY_ARCH_X86 && HWY_MAX_BYTES >= 32

/// The numbers a, b, c, d, a, b, c, d.
HWY_INLINE V Repeated(double a, double b, double c, double e) {
    HWY_ALIGN const double numbers[8] = {a, b, c, e, a, b, c, e};
    return hn::Load(D(), numbers);
}

enum class Phase { open, full, close };

/// Whole grains per vector. Gravity and the other fields act on x and y only.
template <Phase phase>
void Move(const MotionTask& task) {
    const D d;
    const V half = hn::Set(d, task.dt / 2), drift = Repeated(task.dt, task.dt, 0, 0);
    const V gravity = Repeated(0, -task.gravity, 0, 0);
    const V drag = Repeated(-task.drag, -task.drag, 0, 0);
    const V backing = Repeated(task.backing_stiffness, 0, 0, 0);
    const V left = hn::Set(d, task.left), right = hn::Set(d, task.right);
    const auto linear = hn::Gt(Repeated(1, 1, 0, 0), hn::Zero(d));
    const bool has_drag = task.drag != 0, has_backing = task.backing_stiffness != 0;
    auto within = hn::Eq(hn::Zero(d), hn::Zero(d));
    for (std::size_t k = 0; k < task.numbers; k += hn::Lanes(d)) {
        V x = hn::Load(d, task.position + k);
        V v = hn::Load(d, task.velocity + k);
        V a = hn::Load(d, task.force + k);
        if constexpr (phase != Phase::open) {
            const V moment = hn::InterleaveUpper(d, a, a);
            a = hn::IfThenElse(linear, a, hn::InterleaveLower(d, a, a));
            if (has_drag) a = hn::MulAdd(drag, v, a);
            if (has_backing) {
                const V behind = hn::Sub(hn::Max(hn::Sub(left, x), hn::Zero(d)),
                                         hn::Max(hn::Sub(x, right), hn::Zero(d)));
                a = hn::MulAdd(backing, behind, a);
            }
            a = hn::MulAdd(a, hn::Load(d, task.own + k), gravity);
            a = hn::MulAdd(moment, hn::Load(d, task.torque + k), a);
        }
        v = hn::MulAdd(a, half, v);
        if constexpr (phase == Phase::full) v = hn::MulAdd(a, half, v);
        hn::Store(v, d, task.velocity + k);
        if constexpr (phase == Phase::close) {
            hn::Store(a, d, task.force + k);
            continue;
        }
        x = hn::MulAdd(v, drift, x);
        hn::Store(x, d, task.position + k);
        hn::Store(hn::Zero(d), d, task.force + k);
        const V moved = hn::Abs(hn::Sub(x, hn::Load(d, task.listed + k)));
        // Written so that what is no number is not within.
        within = hn::And(within, hn::Le(moved, hn::Load(d, task.margin + k)));
    }
    if constexpr (phase != Phase::close) {
        if (!hn::AllTrue(d, within)) *task.left_margin = true;
    }
}

#endif  // HWY_ARCH_X86 && HWY_MAX_BYTES >= 32

}  // namespace HWY_NAMESPACE
}  // namespace crossgrain::friction
HWY_AFTER_NAMESPACE();

#endif
