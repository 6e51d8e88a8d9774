// Vectors of doubles, and the numbers of many grains gathered into them.
// Included once per instruction set: no include guard but the one Highway asks for.
#if defined(CROSSGRAIN_FRICTION_SIMD_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROSSGRAIN_FRICTION_SIMD_LANES_INL
#undef CROSSGRAIN_FRICTION_SIMD_LANES_INL
#else
#define CROSSGRAIN_FRICTION_SIMD_LANES_INL
#endif

#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace crossgrain::friction {
namespace HWY_NAMESPACE {

#if HWY_ARCH_X86 && HWY_MAX_BYTES >= 32

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

/// The pairs of numbers at base + places[0], places[2], ... as one vector.
template <class DB>
HWY_INLINE hn::Vec<DB> LoadBlocks(DB d, const double* HWY_RESTRICT base,
                                  const std::uint32_t* HWY_RESTRICT places) {
    constexpr std::size_t blocks = hn::MaxLanes(DB()) / 2;
    if constexpr (blocks == 1) {
        return hn::Load(d, base + places[0]);
    } else {
        const hn::Half<DB> half;
        const auto low = LoadBlocks(half, base, places);
        const auto high = LoadBlocks(half, base, places + blocks);
        return hn::Combine(d, high, low);
    }
}

/// Two numbers of each grain, still as they lie in memory: of even pairs and of odd ones.
struct Blocks {
    V even, odd;
    static HWY_INLINE Blocks Load(const double* base, const std::uint32_t* places) {
        const D d;
        return {LoadBlocks(d, base, places), LoadBlocks(d, base, places + 1)};
    }
    HWY_INLINE Blocks Minus(const Blocks& b) const {
        return {hn::Sub(even, b.even), hn::Sub(odd, b.odd)};
    }
    HWY_INLINE Blocks Plus(const Blocks& b) const {
        return {hn::Add(even, b.even), hn::Add(odd, b.odd)};
    }
    HWY_INLINE V First() const { return hn::InterleaveLower(D(), even, odd); }
    HWY_INLINE V Second() const { return hn::InterleaveUpper(D(), even, odd); }
};

/// 1/sqrt(v) to the last bit or two; infinite or no number for v = 0.
HWY_INLINE V ReciprocalRoot(V v) {
    const D d;
#if HWY_TARGET <= HWY_AVX3
    const V guess{_mm512_rsqrt14_pd(v.raw)};
    // With h = 1 - v guess^2: 1/sqrt(v) = guess (1 - h)^(-1/2)
    //                                   = guess (1 + h/2 + 3 h^2/8 + 5 h^3/16 + ...).
    const auto h = hn::NegMulAdd(hn::Mul(v, guess), guess, hn::Set(d, 1.0));
    const auto tail = hn::MulAdd(h, hn::Set(d, 5.0 / 16), hn::Set(d, 3.0 / 8));
    return hn::MulAdd(hn::Mul(guess, h), hn::MulAdd(h, tail, hn::Set(d, 0.5)), guess);
#else
    return hn::Div(hn::Set(d, 1.0), hn::Sqrt(v));
#endif
}

#endif  // HWY_ARCH_X86 && HWY_MAX_BYTES >= 32

}  // namespace HWY_NAMESPACE
}  // namespace crossgrain::friction
HWY_AFTER_NAMESPACE();

#endif
