// contact_law.hpp for as many pairs at once as a vector has lanes. Lanes of pairs that do not touch
// compute what comes and add zero.
// Included once per instruction set: no include guard but the one Highway asks for.
#if defined(CROSSGRAIN_FRICTION_SIMD_CONTACTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROSSGRAIN_FRICTION_SIMD_CONTACTS_INL
#undef CROSSGRAIN_FRICTION_SIMD_CONTACTS_INL
#else
#define CROSSGRAIN_FRICTION_SIMD_CONTACTS_INL
#endif

#include "native/friction/law_choice.hpp"
#include "native/friction/simd_step.hpp"

#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include "native/friction/simd_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace crossgrain::friction {
namespace HWY_NAMESPACE {

#if HWY_ARCH_X86 && HWY_MAX_BYTES >= 32

/// What all pairs share, in registers where there are enough.
struct Law {
    explicit Law(const ForceTask& t)
        : stiffness(hn::Set(D(), t.stiffness)), damping(hn::Set(D(), t.damping)),
          lowest_normal_force(hn::Set(D(), t.lowest_normal_force)),
          friction(hn::Set(D(), t.friction)),
          tangential_stiffness(hn::Set(D(), t.tangential_stiffness)),
          minus_compliance(hn::Set(D(), -1 / t.tangential_stiffness)),
          tangential_damping(hn::Set(D(), t.tangential_damping)),
          spring_time(hn::Set(D(), t.spring_time)) {}

    V stiffness, damping, lowest_normal_force, friction;
    V tangential_stiffness, minus_compliance;  ///< k_t, -1/k_t
    V tangential_damping, spring_time;
};

/// A vector of touching pairs: normal, tangential velocity, and the limits of their friction.
struct Touching {
    M touch;
    V overlap, nx, ny;
    V vt;
    V limit;               ///< mu |F_n|
    V tangential_damping;  ///< gamma_t
};

/// Adds F on i and -F on j, pair after pair: a grain may stand in several lanes.
HWY_INLINE void Scatter(const ForceTask& task, std::size_t first, M touch, V fx, V fy, V ft,
                        V moment) {
    const D d;
    const hn::FixedTag<double, 4> quad;
    HWY_ALIGN double exerted[4 * hn::MaxLanes(D())];
    HWY_ALIGN static constexpr double signs[4] = {-0.0, -0.0, 0.0, 0.0};
    hn::StoreInterleaved4(fx, fy, ft, moment, d, exerted);
    const auto opposite = hn::Load(quad, signs);
    const std::uint32_t* HWY_RESTRICT i = task.pairs->i.data() + first;
    const std::uint32_t* HWY_RESTRICT j = task.pairs->j.data() + first;
    const auto add = [&](std::size_t lane) HWY_ATTR {
        const auto f = hn::Load(quad, exerted + 4 * lane);
        double* on_i = task.force + i[lane];
        double* on_j = task.force + j[lane];
        hn::Store(hn::Add(hn::Load(quad, on_i), f), quad, on_i);
        hn::Store(hn::Add(hn::Load(quad, on_j), hn::Xor(f, opposite)), quad, on_j);
    };
    // In a dilute system a vector has one pair that touches, or two.
    if (hn::CountTrue(d, touch) <= hn::Lanes(d) / 4) {
        std::uint8_t bits[8];
        hn::StoreMaskBits(d, touch, bits);
        for (std::uint32_t left = bits[0]; left != 0; left &= left - 1)
            add(hwy::Num0BitsBelowLS1Bit_Nonzero32(left));
        return;
    }
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
        add(lane);
}

/// |f| cut at the limit, with the sign of f.
HWY_INLINE V CutAt(V limit, V f) {
    return hn::Min(hn::Max(f, hn::Neg(limit)), limit);
}

HWY_INLINE void Remember(V value, M touch, AlignedVector<double>& array, std::size_t first) {
    hn::Store(hn::IfThenElseZero(touch, value), D(), array.data() + first);
}

/// The spring along the tangent after it has followed the normal.
template <SpringRotation rotation>
HWY_INLINE V FollowedSpring(const PairList& pairs, std::size_t first, const Touching& c) {
    const D d;
    const V sx = hn::Load(d, pairs.memory[0].data() + first);
    if constexpr (rotation == SpringRotation::project_and_rescale) {
        return sx;
    } else {
        const V sy = hn::Load(d, pairs.memory[1].data() + first);
        return hn::MulSub(sy, c.nx, hn::Mul(sx, c.ny));
    }
}

/// F_t of springs that lie in the tangent: all but `rotate`.
template <Conventions conventions>
HWY_INLINE V TangentSpring(const Law& law, PairList& pairs, std::size_t first, const Touching& c) {
    const V dashpot = hn::Mul(c.tangential_damping, c.vt);
    V s = hn::MulAdd(c.vt, law.spring_time, FollowedSpring<conventions.rotation>(pairs, first, c));
    V ft = hn::Neg(hn::Mul(law.tangential_stiffness, s));
    if constexpr (conventions.limit == CoulombLimit::total) {
        ft = hn::Sub(ft, dashpot);
        const auto slides = hn::Gt(hn::Abs(ft), c.limit);
        ft = CutAt(c.limit, ft);
        s = hn::IfThenElse(slides, hn::Mul(hn::Add(ft, dashpot), law.minus_compliance), s);
    } else {
        const auto slides = hn::Gt(hn::Abs(ft), c.limit);
        ft = CutAt(c.limit, ft);
        s = hn::IfThenElse(slides, hn::Mul(ft, law.minus_compliance), s);
        ft = hn::Sub(ft, hn::IfThenZeroElse(slides, dashpot));
    }
    if constexpr (conventions.rotation == SpringRotation::project_and_rescale) {
        Remember(s, c.touch, pairs.memory[0], first);
    } else {
        Remember(hn::Neg(hn::Mul(s, c.ny)), c.touch, pairs.memory[0], first);
        Remember(hn::Mul(s, c.nx), c.touch, pairs.memory[1], first);
    }
    return ft;
}

/// F_t of springs turned by s -= s x (n_old x n_new), and `along`, what leans out of the tangent.
template <Conventions conventions>
HWY_INLINE V TurnedSpring(const Law& law, PairList& pairs, std::size_t first, const Touching& c,
                          V& along) {
    const D d;
    const auto load = [&](std::size_t k)
                          HWY_ATTR { return hn::Load(d, pairs.memory[k].data() + first); };
    const V old_x = load(0), old_y = load(1);
    const V turn = hn::MulSub(load(2), c.ny, hn::Mul(load(3), c.nx));
    const V stretch = hn::Mul(c.vt, law.spring_time);
    V sx = hn::NegMulAdd(stretch, c.ny, hn::NegMulAdd(old_y, turn, old_x));
    V sy = hn::MulAdd(stretch, c.nx, hn::MulAdd(old_x, turn, old_y));
    const V minus_kt = hn::Neg(law.tangential_stiffness);
    const V dashpot = hn::Mul(c.tangential_damping, c.vt);
    // -(-n_y, n_x) gamma_t v_t
    const V dashpot_x = hn::Mul(dashpot, c.ny), dashpot_y = hn::Neg(hn::Mul(dashpot, c.nx));
    constexpr bool together = conventions.limit == CoulombLimit::total;
    V fx = hn::Mul(minus_kt, sx), fy = hn::Mul(minus_kt, sy);
    if constexpr (together) fx = hn::Add(fx, dashpot_x), fy = hn::Add(fy, dashpot_y);
    const V magnitude = hn::Sqrt(hn::MulAdd(fx, fx, hn::Mul(fy, fy)));
    const auto slides = hn::Gt(magnitude, c.limit);
    const V factor = hn::IfThenElse(slides, hn::Div(c.limit, magnitude), hn::Set(d, 1.0));
    fx = hn::Mul(fx, factor), fy = hn::Mul(fy, factor);
    if constexpr (together) {
        sx = hn::IfThenElse(slides, hn::Mul(hn::Sub(fx, dashpot_x), law.minus_compliance), sx);
        sy = hn::IfThenElse(slides, hn::Mul(hn::Sub(fy, dashpot_y), law.minus_compliance), sy);
    } else {
        sx = hn::Mul(fx, law.minus_compliance), sy = hn::Mul(fy, law.minus_compliance);
        fx = hn::Add(fx, hn::IfThenZeroElse(slides, dashpot_x));
        fy = hn::Add(fy, hn::IfThenZeroElse(slides, dashpot_y));
    }
    const V values[] = {sx, sy, c.nx, c.ny};
    for (std::size_t k = 0; k < 4; ++k)
        Remember(values[k], c.touch, pairs.memory[k], first);
    along = hn::MulAdd(fx, c.nx, hn::Mul(fy, c.ny));
    return hn::MulSub(fy, c.nx, hn::Mul(fx, c.ny));
}

/// A vector of pairs of which some touch.
template <TangentialForce tangential, Conventions conventions>
HWY_INLINE void Exert(const ForceTask& task, const Law& law, std::size_t first, V dx, V dy,
                      V r_squared, V reach, M touch) {
    const D d;
    PairList& pairs = *task.pairs;
    const std::uint32_t* i = pairs.i.data() + first;
    const std::uint32_t* j = pairs.j.data() + first;
    const V inverse_r = ReciprocalRoot(r_squared);
    Touching c{.touch = touch};
    c.overlap = hn::NegMulAdd(r_squared, inverse_r, reach);
    c.nx = hn::Mul(dx, inverse_r), c.ny = hn::Mul(dy, inverse_r);
    const Blocks v = Blocks::Load(task.velocity, i).Minus(Blocks::Load(task.velocity, j));
    const V vx = v.First(), vy = v.Second();
    const bool own_damping = !pairs.damping.empty();
    const V damping = own_damping ? hn::Load(d, pairs.damping.data() + first) : law.damping;
    const V vn = hn::MulAdd(vx, c.nx, hn::Mul(vy, c.ny));
    V fn = hn::NegMulAdd(damping, vn, hn::Mul(law.stiffness, c.overlap));
    fn = hn::IfThenElseZero(touch, hn::Max(fn, law.lowest_normal_force));
    if constexpr (tangential == TangentialForce::none) {
        Scatter(task, first, touch, hn::Mul(fn, c.nx), hn::Mul(fn, c.ny), hn::Zero(d), hn::Zero(d));
        return;
    }
    const Blocks spins =
        Blocks::Load(task.velocity + 2, i).Plus(Blocks::Load(task.velocity + 2, j));
    const V half_overlap = hn::Mul(c.overlap, hn::Set(d, 0.5));
    // l_i omega_i + l_j omega_j
    V turning = spins.Second();
    if constexpr (conventions.velocity_lever == Lever::contact_point) {
        turning = hn::NegMulAdd(half_overlap, spins.First(), turning);
    }
    c.vt = hn::Sub(hn::MulSub(vy, c.nx, hn::Mul(vx, c.ny)), turning);
    c.limit = hn::Mul(law.friction, hn::Abs(fn));
    c.tangential_damping =
        own_damping ? hn::Load(d, pairs.tangential_damping.data() + first) : law.tangential_damping;
    V ft, along = hn::Zero(d);
    if constexpr (tangential == TangentialForce::dashpot) {
        ft = CutAt(c.limit, hn::Neg(hn::Mul(c.tangential_damping, c.vt)));
    } else if constexpr (conventions.rotation == SpringRotation::rotate) {
        ft = TurnedSpring<conventions>(law, pairs, first, c, along);
    } else {
        ft = TangentSpring<conventions>(law, pairs, first, c);
    }
    ft = hn::IfThenElseZero(touch, ft);
    fn = hn::Add(fn, hn::IfThenElseZero(touch, along));
    const V moment = conventions.torque_lever == Lever::contact_point
                         ? hn::IfThenElseZero(touch, hn::Mul(ft, half_overlap))
                         : hn::Zero(d);
    Scatter(task, first, touch, hn::IfThenElseZero(touch, hn::MulSub(fn, c.nx, hn::Mul(ft, c.ny))),
            hn::IfThenElseZero(touch, hn::MulAdd(fn, c.ny, hn::Mul(ft, c.nx))), ft, moment);
}

HWY_INLINE void Forget(PairList& pairs, std::size_t first) {
    for (auto& array : pairs.memory) {
        if (!array.empty()) hn::Store(hn::Zero(D()), D(), array.data() + first);
    }
}

template <TangentialForce tangential, Conventions conventions>
void AddContactForces(const ForceTask& asked) {
    const D d;
    const ForceTask task = asked;
    const Law law(task);
    PairList& pairs = *task.pairs;
    const std::size_t lanes = hn::Lanes(d);
    std::size_t worked_out = 0;
    for (std::size_t first = 0; first < pairs.i.size(); first += lanes) {
        const Blocks separation = Blocks::Load(task.position, pairs.i.data() + first)
                                      .Minus(Blocks::Load(task.position, pairs.j.data() + first));
        const V dx = hn::Add(separation.First(), hn::Load(d, pairs.shift_x.data() + first));
        const V dy = hn::Add(separation.Second(), hn::Load(d, pairs.shift_y.data() + first));
        const V r_squared = hn::MulAdd(dx, dx, hn::Mul(dy, dy));
        const V reach = hn::Load(d, pairs.reach.data() + first);
        const auto touch = hn::Lt(r_squared, hn::Mul(reach, reach));
        std::uint8_t& remembers = pairs.remembers[first / 4];
        if (hn::AllFalse(d, touch)) {
            if (remembers) Forget(pairs, first);
            remembers = 0;
            continue;
        }
        remembers = 1;
        worked_out += lanes;
        Exert<tangential, conventions>(task, law, first, dx, dy, r_squared, reach, touch);
    }
    pairs.worked_out += static_cast<std::int64_t>(worked_out);
}

#endif  // HWY_ARCH_X86 && HWY_MAX_BYTES >= 32

}  // namespace HWY_NAMESPACE
}  // namespace crossgrain::friction
HWY_AFTER_NAMESPACE();

#endif
