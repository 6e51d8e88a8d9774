// Words of bits, one replica per bit: what the bit-sliced engine does with them, for the Highway
// target that is being compiled.
#if defined(CROSSGRAIN_LGA_WORDS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROSSGRAIN_LGA_WORDS_INL
#undef CROSSGRAIN_LGA_WORDS_INL
#else
#define CROSSGRAIN_LGA_WORDS_INL
#endif

#include "native/lga/bit_source-inl.hpp"
#include "native/lga/probability.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace crossgrain::lga::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Words of `lanes` 64-bit lanes.
template <std::size_t lanes>
struct Words {
    using D = hn::FixedTag<std::uint64_t, lanes>;
    using V = hn::Vec<D>;
    static constexpr D d{};
    static constexpr std::size_t size = lanes;

    static HWY_INLINE V load(const std::uint64_t* p) { return hn::Load(d, p); }
    static HWY_INLINE void store(V v, std::uint64_t* p) { hn::Store(v, d, p); }
    static HWY_INLINE V none() { return hn::Zero(d); }
    static HWY_INLINE V all() { return hn::Set(d, ~std::uint64_t{0}); }
    static HWY_INLINE bool is_zero(V v) { return hn::AllTrue(d, hn::Eq(v, hn::Zero(d))); }
    /// a and not b
    static HWY_INLINE V without(V a, V b) { return hn::AndNot(b, a); }
    static HWY_INLINE V choose(V mask, V yes, V no) {
        return hn::Or(hn::And(mask, yes), hn::AndNot(mask, no));
    }
};

#if HWY_TARGET == HWY_SCALAR
template <std::size_t lanes>
using SourceOf = HalfBlockSource;
#else
template <std::size_t lanes>
using SourceOf =
    std::conditional_t<lanes == 1, HalfBlockSource, BitSource<hn::FixedTag<std::uint64_t, lanes>>>;
#endif

/// After so many bits of a decision all replicas are likely to be decided.
inline constexpr int bits_before_exit = 11;

/// Decisions at `sites` sites at once, so that one's arithmetic hides the other's latency: those of
/// `asking` with u < below * 2^-24. The bits of u, most significant first, are compared until all
/// are decided. `counters` are those of the first bit.
template <class W, std::size_t sites, class Source, class Counters>
HWY_INLINE void decide(const Source& source, const Counters (&counters)[sites], std::uint32_t below,
                       const typename W::V (&asking)[sites], typename W::V (&less)[sites]) {
    const int bits = deciding_bits(below);
    typename W::V equal[sites];
    Counters now[sites];
    for (std::size_t i = 0; i < sites; ++i) {
        less[i] = below >= certain ? asking[i] : W::none();
        equal[i] = asking[i];
        now[i] = counters[i];
    }
    for (int known = 0; known < bits;) {
        for (const int end = std::min(bits, known + bits_before_exit); known < end; ++known) {
            const bool one = (below >> (probability_bits - 1 - known) & 1U) != 0;
            for (std::size_t i = 0; i < sites; ++i) {
                const auto u = source(now[i]);
                now[i] = Source::later(now[i], 1);
                if (one) less[i] = hn::Or(less[i], W::without(equal[i], u));
                equal[i] = one ? hn::And(equal[i], u) : W::without(equal[i], u);
            }
        }
        if (known == bits) return;
        auto undecided = equal[0];
        for (std::size_t i = 1; i < sites; ++i)
            undecided = hn::Or(undecided, equal[i]);
        if (W::is_zero(undecided)) return;
    }
}

/// At one site.
template <class W, class Source, class Counters>
HWY_INLINE typename W::V decide(const Source& source, const Counters& counters, std::uint32_t below,
                                typename W::V asking) {
    const Counters all_counters[1] = {counters};
    const typename W::V all_asking[1] = {asking};
    typename W::V less[1];
    decide<W, 1>(source, all_counters, below, all_asking, less);
    return less[0];
}

}  // namespace crossgrain::lga::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
