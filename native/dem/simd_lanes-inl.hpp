// One vector of grains: how records become lanes and back, per instruction set (Highway).
// Included once per instruction set: no include guard but the one Highway asks for.
#if defined(CROSSGRAIN_DEM_SIMD_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROSSGRAIN_DEM_SIMD_LANES_INL
#undef CROSSGRAIN_DEM_SIMD_LANES_INL
#else
#define CROSSGRAIN_DEM_SIMD_LANES_INL
#endif

#include "native/dem/simd_format.hpp"

#include <hwy/highway.h>

#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace crossgrain::dem {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

/// The 128-bit blocks at base + offsets[0], offsets[stride], offsets[2 stride], ... as one vector.
template <class D>
HWY_INLINE hn::Vec<D> LoadBlocks(D d, const std::uint8_t* HWY_RESTRICT base,
                                 const std::uint32_t* HWY_RESTRICT offsets, std::size_t stride) {
    using T = hn::TFromD<D>;
    constexpr std::size_t blocks = hn::MaxLanes(D()) * sizeof(T) / 16;
    if constexpr (blocks == 1) {
        return hn::LoadU(d, reinterpret_cast<const T*>(base + offsets[0]));
    } else {
        const hn::Half<D> half;
        const auto low = LoadBlocks(half, base, offsets, stride);
        const auto high = LoadBlocks(half, base, offsets + stride * blocks / 2, stride);
        return hn::Combine(d, high, low);
    }
}

/// 1/sqrt(v) to the last bit or two; infinite or no number for v = 0.
template <class D>
HWY_INLINE hn::Vec<D> ReciprocalRoot(D d, hn::Vec<D> v) {
    using T = hn::TFromD<D>;
    const auto half = hn::Set(d, T(0.5));
    // Newton: guess (1 + (1 - v guess^2)/2) has twice as many good bits.
    const auto improved = [&](hn::Vec<D> guess) HWY_ATTR {
        const auto half_residual = hn::NegMulAdd(hn::Mul(v, guess), hn::Mul(guess, half), half);
        return hn::MulAdd(guess, half_residual, guess);
    };
    if constexpr (std::is_same_v<T, float>) {
        return improved(hn::ApproximateReciprocalSqrt(v));
    } else {
#if HWY_TARGET <= HWY_AVX3
        const hn::Vec<D> guess{_mm512_rsqrt14_pd(v.raw)};
#else
        const hn::Rebind<float, D> narrow;
        const auto guess =
            improved(hn::PromoteTo(d, hn::ApproximateReciprocalSqrt(hn::DemoteTo(narrow, v))));
#endif
        // With h = 1 - v guess^2: 1/sqrt(v) = guess (1 - h)^(-1/2)
        //                                   = guess (1 + h/2 + 3 h^2/8 + 5 h^3/16 + ...).
        const auto h = hn::NegMulAdd(hn::Mul(v, guess), guess, hn::Set(d, 1.0));
        const auto tail = hn::MulAdd(h, hn::Set(d, 5.0 / 16), hn::Set(d, 3.0 / 8));
        return hn::MulAdd(hn::Mul(guess, h), hn::MulAdd(h, tail, half), guess);
    }
}

/// The grains of a group, or one neighbour of each.
template <class Format>
struct Lanes;

template <>
struct Lanes<MixedFormat> {
    using D = hn::ScalableTag<float>;
    using DP = hn::ScalableTag<std::int32_t>;
    using V = hn::Vec<D>;
    using P = hn::Vec<DP>;
    P x, y;
    V vx, vy;

    /// Blocks of a record are 4 lanes wide: a transposition within blocks makes vectors of them.
    static HWY_INLINE Lanes Load(const MixedFormat::Record* HWY_RESTRICT records,
                                 const std::uint32_t* HWY_RESTRICT offsets) {
        const D d;
        const DP dp;
        const hn::Repartition<double, D> pairs;
        const auto* base = reinterpret_cast<const std::uint8_t*>(records);
        const auto r0 = LoadBlocks(d, base, offsets, 4);
        const auto r1 = LoadBlocks(d, base, offsets + 1, 4);
        const auto r2 = LoadBlocks(d, base, offsets + 2, 4);
        const auto r3 = LoadBlocks(d, base, offsets + 3, 4);
        const auto xy01 = hn::BitCast(pairs, hn::InterleaveLower(d, r0, r1));
        const auto xy23 = hn::BitCast(pairs, hn::InterleaveLower(d, r2, r3));
        const auto v01 = hn::BitCast(pairs, hn::InterleaveUpper(d, r0, r1));
        const auto v23 = hn::BitCast(pairs, hn::InterleaveUpper(d, r2, r3));
        return {hn::BitCast(dp, hn::InterleaveLower(pairs, xy01, xy23)),
                hn::BitCast(dp, hn::InterleaveUpper(pairs, xy01, xy23)),
                hn::BitCast(d, hn::InterleaveLower(pairs, v01, v23)),
                hn::BitCast(d, hn::InterleaveUpper(pairs, v01, v23))};
    }

    static HWY_INLINE Lanes LoadGroup(const MixedFormat::Record* HWY_RESTRICT first) {
        const D d;
        const DP dp;
        V x, y, vx, vy;
        hn::LoadInterleaved4(d, reinterpret_cast<const float*>(first), x, y, vx, vy);
        return {hn::BitCast(dp, x), hn::BitCast(dp, y), vx, vy};
    }

    HWY_INLINE void StoreGroup(MixedFormat::Record* HWY_RESTRICT first) const {
        const D d;
        hn::StoreInterleaved4(hn::BitCast(d, x), hn::BitCast(d, y), vx, vy, d,
                              reinterpret_cast<float*>(first));
    }

    /// a - b as a length. Wraps round the period by itself.
    static HWY_INLINE V Separation(P a, P b, V unit) {
        return hn::Mul(hn::ConvertTo(D(), hn::Sub(a, b)), unit);
    }
    /// position + steps velocity, `steps` = dt/unit.
    static HWY_INLINE P Drift(P position, V velocity, V steps) {
        return hn::Add(position, hn::NearestInt(hn::Mul(velocity, steps)));
    }
};

template <>
struct Lanes<DoubleFormat> {
    using D = hn::ScalableTag<double>;
    using DP = D;
    using V = hn::Vec<D>;
    using P = V;
    P x, y;
    V vx, vy;

    static HWY_INLINE Lanes Load(const DoubleFormat::Record* HWY_RESTRICT records,
                                 const std::uint32_t* HWY_RESTRICT offsets) {
        const D d;
        const auto* positions = reinterpret_cast<const std::uint8_t*>(records);
        const auto* velocities = positions + 2 * sizeof(double);
        const auto xy0 = LoadBlocks(d, positions, offsets, 2);
        const auto xy1 = LoadBlocks(d, positions, offsets + 1, 2);
        const auto v0 = LoadBlocks(d, velocities, offsets, 2);
        const auto v1 = LoadBlocks(d, velocities, offsets + 1, 2);
        return {hn::InterleaveLower(d, xy0, xy1), hn::InterleaveUpper(d, xy0, xy1),
                hn::InterleaveLower(d, v0, v1), hn::InterleaveUpper(d, v0, v1)};
    }

    static HWY_INLINE Lanes LoadGroup(const DoubleFormat::Record* HWY_RESTRICT first) {
        Lanes g;
        hn::LoadInterleaved4(D(), reinterpret_cast<const double*>(first), g.x, g.y, g.vx, g.vy);
        return g;
    }

    HWY_INLINE void StoreGroup(DoubleFormat::Record* HWY_RESTRICT first) const {
        hn::StoreInterleaved4(x, y, vx, vy, D(), reinterpret_cast<double*>(first));
    }

    static HWY_INLINE V Separation(P a, P b, V) { return hn::Sub(a, b); }
    static HWY_INLINE P Drift(P position, V velocity, V steps) {
        return hn::MulAdd(velocity, steps, position);
    }
};

#endif  // HWY_TARGET != HWY_SCALAR

}  // namespace HWY_NAMESPACE
}  // namespace crossgrain::dem
HWY_AFTER_NAMESPACE();

#endif
