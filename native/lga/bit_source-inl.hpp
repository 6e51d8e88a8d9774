// Words of random bits for the Highway target that is being compiled: ARS4x32-7 with the
// processor's AES rounds, or in plain C++ where Highway has no vectors. The bits are the same.
#if defined(CROSSGRAIN_LGA_BIT_SOURCE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROSSGRAIN_LGA_BIT_SOURCE_INL
#undef CROSSGRAIN_LGA_BIT_SOURCE_INL
#else
#define CROSSGRAIN_LGA_BIT_SOURCE_INL
#endif

#include "native/lga/ars_portable.hpp"
#include "native/lga/random_bits.hpp"

#include <hwy/highway.h>

#include <cstdint>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace crossgrain::lga::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

/// ARS on vectors: D has 64-bit lanes, an even number of them, and each pair is one block.
template <class D>
class Ars {
  public:
    using V = hn::Vec<D>;

    explicit Ars(const RoundKeys& keys) {
        for (std::size_t i = 0; i <= RoundKeys::rounds; ++i) {
            for (std::size_t lane = 0; lane < hn::MaxLanes(D()); ++lane) {
                keys_[i][lane] = keys[i][lane % 2];
            }
        }
    }
    [[nodiscard]] HWY_INLINE V operator()(V counters) const {
        auto state = hn::BitCast(bytes_, hn::Xor(counters, hn::Load(D(), keys_[0])));
        for (std::size_t i = 1; i < RoundKeys::rounds; ++i) {
            state = hn::AESRound(state, key(i));
        }
        return hn::BitCast(D(), hn::AESLastRound(state, key(RoundKeys::rounds)));
    }

  private:
    using Bytes = hn::Repartition<std::uint8_t, D>;
    static constexpr Bytes bytes_{};
    [[nodiscard]] HWY_INLINE hn::Vec<Bytes> key(std::size_t i) const {
        return hn::BitCast(bytes_, hn::Load(D(), keys_[i]));
    }
    alignas(64) std::uint64_t keys_[RoundKeys::rounds + 1][hn::MaxLanes(D())];
};

/// Words of as many replicas as D has bits (several blocks), from replica 64 * `first_word` on.
template <class D>
class BitSource {
  public:
    using V = hn::Vec<D>;
    using Counters = V;

    BitSource(const RoundKeys& keys, int first_word)
        : ars_(keys), first_block_(static_cast<std::uint32_t>(first_word / 2)) {}

    /// Counters of draw 0 at a site.
    [[nodiscard]] HWY_INLINE V at(std::int64_t step, std::uint32_t site) const {
        const Counter first = counter(step, site, first_block_);
        alignas(64) std::uint64_t lanes[hn::MaxLanes(D())];
        for (std::size_t i = 0; i < hn::MaxLanes(D()); i += 2) {
            lanes[i] = first.low;
            lanes[i + 1] = first.high + (std::uint64_t{i / 2} << 32);
        }
        return hn::Load(D(), lanes);
    }
    /// The counters of the next site.
    [[nodiscard]] HWY_INLINE static V next_site(V counters) {
        return hn::Add(counters, hn::OddEven(hn::Zero(D()), hn::Set(D(), std::uint64_t{1} << 32)));
    }
    /// The counters of a later draw.
    [[nodiscard]] HWY_INLINE static V later(V counters, std::uint64_t draws) {
        return hn::Add(counters, hn::OddEven(hn::Set(D(), draws), hn::Zero(D())));
    }
    [[nodiscard]] HWY_INLINE V operator()(V counters) const { return ars_(counters); }

  private:
    Ars<D> ars_;
    std::uint32_t first_block_;
};

#endif

/// 64 replicas: half a block.
class HalfBlockSource {
  public:
    using V = hn::Vec<hn::FixedTag<std::uint64_t, 1>>;

    HalfBlockSource(const RoundKeys& keys, int first_word) : keys_(keys), word_(first_word) {}

    struct Counters {
        Counter value{};
    };
    [[nodiscard]] Counters at(std::int64_t step, std::uint32_t site) const {
        return {counter(step, site, static_cast<std::uint32_t>(word_ / 2))};
    }
    [[nodiscard]] static Counters next_site(Counters c) {
        c.value.low += std::uint64_t{1} << 32;
        return c;
    }
    [[nodiscard]] static Counters later(Counters c, std::uint64_t draws) {
        c.value.high += draws;
        return c;
    }
    [[nodiscard]] HWY_INLINE V operator()(Counters c) const {
        return hn::Set(hn::FixedTag<std::uint64_t, 1>(), block(c.value)[word_ % 2]);
    }

  private:
    struct Block {
        alignas(16) std::uint64_t words[2];
        std::uint64_t operator[](int i) const { return words[i]; }
    };
#if HWY_TARGET == HWY_SCALAR
    [[nodiscard]] Block block(const Counter& c) const {
        const auto words = portable_block(keys_, c);
        return {{words[0], words[1]}};
    }
    RoundKeys keys_;
#else
    [[nodiscard]] HWY_INLINE Block block(const Counter& c) const {
        const hn::FixedTag<std::uint64_t, 2> d;
        const Block in{{c.low, c.high}};
        Block out;
        hn::Store(keys_(hn::Load(d, in.words)), d, out.words);
        return out;
    }
    Ars<hn::FixedTag<std::uint64_t, 2>> keys_;
#endif
    int word_;
};

}  // namespace crossgrain::lga::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
