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
#if HWY_TARGET <= HWY_AVX3
    if constexpr (blocks == 4) {
        const hn::Half<D> half;
        // Not Combine, which clears the upper half first.
        if constexpr (std::is_same_v<T, float>) {
            return hn::Vec<D>{_mm512_insertf32x8(
                _mm512_castps256_ps512(LoadBlocks(half, base, offsets, stride).raw),
                LoadBlocks(half, base, offsets + 2 * stride, stride).raw, 1)};
        } else {
            return hn::Vec<D>{_mm512_insertf64x4(
                _mm512_castpd256_pd512(LoadBlocks(half, base, offsets, stride).raw),
                LoadBlocks(half, base, offsets + 2 * stride, stride).raw, 1)};
        }
    } else
#endif
        if constexpr (blocks == 1) {
        return hn::LoadU(d, reinterpret_cast<const T*>(base + offsets[0]));
    } else {
        const hn::Half<D> half;
        const auto low = LoadBlocks(half, base, offsets, stride);
        const auto high = LoadBlocks(half, base, offsets + stride * blocks / 2, stride);
        return hn::Combine(d, high, low);
    }
}

/// Stores past the caches: what is next read after a whole pass over more than they hold need not
/// be fetched to be overwritten, nor push out what is read meanwhile.
template <bool past_caches, class D>
HWY_INLINE void Store(hn::Vec<D> v, D d, hn::TFromD<D>* HWY_RESTRICT aligned) {
    if constexpr (past_caches) {
        hn::Stream(v, d, aligned);
    } else {
        hn::StoreU(v, d, aligned);
    }
}

/// The grains of a group. Which lane holds which grain, GroupShape::place_of_lane tells: records
/// are transposed within blocks of 128 bits only.
template <class Format>
struct Lanes;

template <>
struct Lanes<MixedFormat> {
    using D = hn::ScalableTag<float>;
    using DP = hn::ScalableTag<std::int32_t>;
    using V = hn::Vec<D>;
    using P = hn::Vec<DP>;
    using Pairs = hn::Repartition<double, D>;
    static constexpr std::size_t blocks = hn::MaxLanes(D()) / 4;
    P x, y;
    V vx, vy;

    /// One neighbour of each grain of a group; velocities are only taken out where asked for.
    struct Neighbours {
        V r0, r1, r2, r3;  ///< blocks are records

        static HWY_INLINE Neighbours Load(const MixedFormat::Record* HWY_RESTRICT records,
                                          const std::uint32_t* HWY_RESTRICT offsets) {
            const D d;
            const auto* base = reinterpret_cast<const std::uint8_t*>(records);
            return {LoadBlocks(d, base, offsets, 4), LoadBlocks(d, base, offsets + 1, 4),
                    LoadBlocks(d, base, offsets + 2, 4), LoadBlocks(d, base, offsets + 3, 4)};
        }
        static HWY_INLINE Neighbours OfGroup(const MixedFormat::Record* HWY_RESTRICT first) {
            const D d;
            const auto* numbers = reinterpret_cast<const float*>(first);
            return {hn::LoadU(d, numbers), hn::LoadU(d, numbers + hn::Lanes(d)),
                    hn::LoadU(d, numbers + 2 * hn::Lanes(d)),
                    hn::LoadU(d, numbers + 3 * hn::Lanes(d))};
        }
        [[nodiscard]] HWY_INLINE P X() const {
            return hn::BitCast(DP(), hn::InterleaveLower(Pairs(), Positions01(), Positions23()));
        }
        [[nodiscard]] HWY_INLINE P Y() const {
            return hn::BitCast(DP(), hn::InterleaveUpper(Pairs(), Positions01(), Positions23()));
        }
        [[nodiscard]] HWY_INLINE V Vx() const {
            return hn::BitCast(D(), hn::InterleaveLower(Pairs(), Velocities01(), Velocities23()));
        }
        [[nodiscard]] HWY_INLINE V Vy() const {
            return hn::BitCast(D(), hn::InterleaveUpper(Pairs(), Velocities01(), Velocities23()));
        }

      private:
        [[nodiscard]] HWY_INLINE hn::Vec<Pairs> Positions01() const {
            return hn::BitCast(Pairs(), hn::InterleaveLower(D(), r0, r1));
        }
        [[nodiscard]] HWY_INLINE hn::Vec<Pairs> Positions23() const {
            return hn::BitCast(Pairs(), hn::InterleaveLower(D(), r2, r3));
        }
        [[nodiscard]] HWY_INLINE hn::Vec<Pairs> Velocities01() const {
            return hn::BitCast(Pairs(), hn::InterleaveUpper(D(), r0, r1));
        }
        [[nodiscard]] HWY_INLINE hn::Vec<Pairs> Velocities23() const {
            return hn::BitCast(Pairs(), hn::InterleaveUpper(D(), r2, r3));
        }
    };

    static HWY_INLINE Lanes LoadGroup(const MixedFormat::Record* HWY_RESTRICT first) {
        Lanes group;
        group.LoadPositions(first);
        group.LoadVelocities(first);
        return group;
    }
    HWY_INLINE void LoadPositions(const MixedFormat::Record* HWY_RESTRICT first) {
        const Neighbours g = Neighbours::OfGroup(first);
        x = g.X();
        y = g.Y();
    }
    HWY_INLINE void LoadVelocities(const MixedFormat::Record* HWY_RESTRICT first) {
        const Neighbours g = Neighbours::OfGroup(first);
        vx = g.Vx();
        vy = g.Vy();
    }

    template <bool past_caches = false>
    HWY_INLINE void StoreGroup(MixedFormat::Record* HWY_RESTRICT first) const {
        const D d;
        const Pairs pairs;
        auto* numbers = reinterpret_cast<float*>(first);
        const auto xf = hn::BitCast(d, x), yf = hn::BitCast(d, y);
        const auto xy01 = hn::BitCast(pairs, hn::InterleaveLower(d, xf, yf));
        const auto xy23 = hn::BitCast(pairs, hn::InterleaveUpper(d, xf, yf));
        const auto v01 = hn::BitCast(pairs, hn::InterleaveLower(d, vx, vy));
        const auto v23 = hn::BitCast(pairs, hn::InterleaveUpper(d, vx, vy));
        const auto store = [&](hn::Vec<Pairs> records, std::size_t k) HWY_ATTR {
            Store<past_caches>(hn::BitCast(d, records), d, numbers + k * hn::Lanes(d));
        };
        store(hn::InterleaveLower(pairs, xy01, v01), 0);
        store(hn::InterleaveUpper(pairs, xy01, v01), 1);
        store(hn::InterleaveLower(pairs, xy23, v23), 2);
        store(hn::InterleaveUpper(pairs, xy23, v23), 3);
    }

    /// a - b in units of position. Wraps round the period by itself.
    static HWY_INLINE V Difference(P a, P b) { return hn::ConvertTo(D(), hn::Sub(a, b)); }
    static HWY_INLINE V InUnitsOfX(V dy, V aspect) { return hn::Mul(dy, aspect); }
    static HWY_INLINE V DistanceSquared(V dx, V dy, V aspect_squared) {
        return hn::MulAdd(hn::Mul(dy, dy), aspect_squared, hn::Mul(dx, dx));
    }
    /// position + steps velocity, `steps` = dt/unit.
    static HWY_INLINE P Drift(P position, V velocity, V steps) {
        return hn::Add(position, Nearest(hn::Mul(velocity, steps)));
    }

  private:
    /// NearestInt without its care for what is beyond all integers, which is an error anyhow.
    static HWY_INLINE P Nearest(V v) {
#if HWY_TARGET <= HWY_AVX3
        return P{_mm512_cvtps_epi32(v.raw)};
#elif HWY_TARGET == HWY_AVX2
        return P{_mm256_cvtps_epi32(v.raw)};
#else
        return hn::NearestInt(v);
#endif
    }
};

template <>
struct Lanes<DoubleFormat> {
    using D = hn::ScalableTag<double>;
    using DP = D;
    using V = hn::Vec<D>;
    using P = V;
    static constexpr std::size_t blocks = hn::MaxLanes(D()) / 2;
    P x, y;
    V vx, vy;

    struct Neighbours {
        V xy0, xy1, v0, v1;  ///< blocks are halves of records

        static HWY_INLINE Neighbours Load(const DoubleFormat::Record* HWY_RESTRICT records,
                                          const std::uint32_t* HWY_RESTRICT offsets) {
            const D d;
            const auto* positions = reinterpret_cast<const std::uint8_t*>(records);
            const auto* velocities = positions + 2 * sizeof(double);
            return {LoadBlocks(d, positions, offsets, 2), LoadBlocks(d, positions, offsets + 1, 2),
                    LoadBlocks(d, velocities, offsets, 2),
                    LoadBlocks(d, velocities, offsets + 1, 2)};
        }
        [[nodiscard]] HWY_INLINE P X() const { return hn::InterleaveLower(D(), xy0, xy1); }
        [[nodiscard]] HWY_INLINE P Y() const { return hn::InterleaveUpper(D(), xy0, xy1); }
        [[nodiscard]] HWY_INLINE V Vx() const { return hn::InterleaveLower(D(), v0, v1); }
        [[nodiscard]] HWY_INLINE V Vy() const { return hn::InterleaveUpper(D(), v0, v1); }
    };

    static HWY_INLINE Lanes LoadGroup(const DoubleFormat::Record* HWY_RESTRICT first) {
        Lanes group;
        group.LoadPositions(first);
        group.LoadVelocities(first);
        return group;
    }
    HWY_INLINE void LoadPositions(const DoubleFormat::Record* HWY_RESTRICT first) {
        const D d;
        const auto* numbers = reinterpret_cast<const double*>(first);
        const auto xy0 = EvenBlocks(hn::LoadU(d, numbers), hn::LoadU(d, numbers + hn::Lanes(d)));
        const auto xy1 = EvenBlocks(hn::LoadU(d, numbers + 2 * hn::Lanes(d)),
                                    hn::LoadU(d, numbers + 3 * hn::Lanes(d)));
        x = hn::InterleaveLower(d, xy0, xy1);
        y = hn::InterleaveUpper(d, xy0, xy1);
    }
    HWY_INLINE void LoadVelocities(const DoubleFormat::Record* HWY_RESTRICT first) {
        const D d;
        const auto* numbers = reinterpret_cast<const double*>(first);
        const auto v0 = OddBlocks(hn::LoadU(d, numbers), hn::LoadU(d, numbers + hn::Lanes(d)));
        const auto v1 = OddBlocks(hn::LoadU(d, numbers + 2 * hn::Lanes(d)),
                                  hn::LoadU(d, numbers + 3 * hn::Lanes(d)));
        vx = hn::InterleaveLower(d, v0, v1);
        vy = hn::InterleaveUpper(d, v0, v1);
    }

    template <bool past_caches = false>
    HWY_INLINE void StoreGroup(DoubleFormat::Record* HWY_RESTRICT first) const {
        const D d;
        auto* numbers = reinterpret_cast<double*>(first);
        const auto xy0 = hn::InterleaveLower(d, x, y), xy1 = hn::InterleaveUpper(d, x, y);
        const auto v0 = hn::InterleaveLower(d, vx, vy), v1 = hn::InterleaveUpper(d, vx, vy);
        Store<past_caches>(LowerBlocks(xy0, v0), d, numbers);
        Store<past_caches>(UpperBlocks(xy0, v0), d, numbers + hn::Lanes(d));
        Store<past_caches>(LowerBlocks(xy1, v1), d, numbers + 2 * hn::Lanes(d));
        Store<past_caches>(UpperBlocks(xy1, v1), d, numbers + 3 * hn::Lanes(d));
    }

    static HWY_INLINE V Difference(P a, P b) { return hn::Sub(a, b); }
    static HWY_INLINE V InUnitsOfX(V dy, V) { return dy; }
    static HWY_INLINE V DistanceSquared(V dx, V dy, V) {
        return hn::MulAdd(dx, dx, hn::Mul(dy, dy));
    }
    static HWY_INLINE P Drift(P position, V velocity, V steps) {
        return hn::MulAdd(velocity, steps, position);
    }

  private:
    // Blocks 0, 2, ... and 1, 3, ... of a and then b; and their inverses: blocks of a and b in
    // turns, from their lower and from their upper halves.
#if HWY_TARGET <= HWY_AVX3
    static HWY_INLINE V EvenBlocks(V a, V b) {
        return V{_mm512_shuffle_f64x2(a.raw, b.raw, 0x88)};
    }
    static HWY_INLINE V OddBlocks(V a, V b) {
        return V{_mm512_shuffle_f64x2(a.raw, b.raw, 0xDD)};
    }
    static HWY_INLINE V LowerBlocks(V a, V b) {
        const auto turns = _mm512_setr_epi64(0, 1, 8, 9, 2, 3, 10, 11);
        return V{_mm512_permutex2var_pd(a.raw, turns, b.raw)};
    }
    static HWY_INLINE V UpperBlocks(V a, V b) {
        const auto turns = _mm512_setr_epi64(4, 5, 12, 13, 6, 7, 14, 15);
        return V{_mm512_permutex2var_pd(a.raw, turns, b.raw)};
    }
#else
    static_assert(blocks <= 2);
    static HWY_INLINE V EvenBlocks(V a, V b) {
        if constexpr (blocks == 1) return a;
        return hn::ConcatLowerLower(D(), b, a);
    }
    static HWY_INLINE V OddBlocks(V a, V b) {
        if constexpr (blocks == 1) return b;
        return hn::ConcatUpperUpper(D(), b, a);
    }
    static HWY_INLINE V LowerBlocks(V a, V b) {
        return EvenBlocks(a, b);
    }
    static HWY_INLINE V UpperBlocks(V a, V b) {
        return OddBlocks(a, b);
    }
#endif
};

/// a - b as a length.
template <class Format>
HWY_INLINE typename Lanes<Format>::V Separation(typename Lanes<Format>::P a,
                                                typename Lanes<Format>::P b,
                                                typename Lanes<Format>::V unit) {
    return hn::Mul(Lanes<Format>::Difference(a, b), unit);
}

#endif  // HWY_TARGET != HWY_SCALAR

}  // namespace HWY_NAMESPACE
}  // namespace crossgrain::dem
HWY_AFTER_NAMESPACE();

#endif
