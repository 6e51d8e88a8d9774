// The collisions of neighbouring sites in all replicas of a word, as a CollisionPlan says.
#if defined(CROSSGRAIN_LGA_SLICED_COLLISION_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROSSGRAIN_LGA_SLICED_COLLISION_INL
#undef CROSSGRAIN_LGA_SLICED_COLLISION_INL
#else
#define CROSSGRAIN_LGA_SLICED_COLLISION_INL
#endif

#include "native/lga/aligned_words.hpp"
#include "native/lga/collision_plan.hpp"
#include "native/lga/words-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace crossgrain::lga::HWY_NAMESPACE {

/// Works on up to `batch` sites at once: reading the plan costs as much for all of them as for one.
template <std::size_t lanes>
class SlicedCollision {
  public:
    static constexpr bool is_compiled = false;
    static constexpr std::size_t batch = lanes == 8 ? 2 : 4;
    using W = Words<lanes>;
    using V = typename W::V;
    using State = V[flip_outputs];  ///< movers 0..5, rest 6

    explicit SlicedCollision(const CollisionPlan& plan)
        : decisions_(plan.decisions), first_computed_(offset(plan.first_computed_mask())),
          masks_(aligned_words(plan.mask_count() * stride)),
          minterms_(aligned_words((plan.configurations.size() + 1) * stride)) {
        for (const auto& m : plan.masks) {
            computed_.push_back({offset(m.variable), offset(m.yes), offset(m.no)});
        }
        for (const auto& c : plan.configurations) {
            Configuration placed{.even = offset(c.even),
                                 .odd = offset(c.odd),
                                 .has_excess = c.has_excess,
                                 .masks = {}};
            std::ranges::transform(c.mask, placed.masks.begin(), offset);
            configurations_.push_back(placed);
        }
        for (std::size_t i = 0; i < batch; ++i) {
            W::store(W::none(), masks_.get() + offset(never_mask) + i * lanes);
            W::store(W::all(), masks_.get() + offset(always_mask) + i * lanes);
        }
    }

    /// Collides the states of successive sites. Excess rests of a site are written to
    /// `next_excess()`, one word per output, see collision_plan.hpp, and reported by `made(site)`.
    template <std::size_t sites, class Source, class Counters, class NextExcess, class Made>
    HWY_INLINE void operator()(State (&states)[sites], const Source& source,
                               const Counters (&counters)[sites], const NextExcess& next_excess,
                               const Made& made) {
        static_assert(sites <= batch);
        find_minterms(states);
        decide_all<sites>(source, counters);
        compute_masks<sites>();
        for (std::size_t i = 0; i < sites; ++i) {
            if (change(states[i], i, next_excess())) made(i);
        }
    }

  private:
    /// 64-bit lanes between one item and the next: the words of all sites of a batch are
    /// neighbours.
    static constexpr std::size_t stride = batch * lanes;
    using Offset = std::uint32_t;
    static Offset offset(int item) {
        return static_cast<Offset>(item) * static_cast<Offset>(stride);
    }

    struct Computed {
        Offset variable, yes, no;
    };
    struct Configuration {
        Offset even, odd;
        bool has_excess;
        std::array<Offset, outputs> masks;
    };

    [[nodiscard]] HWY_INLINE V mask(Offset item, std::size_t site) const {
        return W::load(masks_.get() + item + site * lanes);
    }

    /// All eight products of three states and their complements; the first is the lowest bit.
    static HWY_INLINE void products(V a, V b, V c, std::uint64_t* to) {
        const V neither = hn::AndNot(a, hn::Not(b)), only_a = W::without(a, b);
        const V only_b = W::without(b, a), both = hn::And(a, b);
        W::store(W::without(neither, c), to);
        W::store(W::without(only_a, c), to + stride);
        W::store(W::without(only_b, c), to + 2 * stride);
        W::store(W::without(both, c), to + 3 * stride);
        W::store(hn::And(neither, c), to + 4 * stride);
        W::store(hn::And(only_a, c), to + 5 * stride);
        W::store(hn::And(only_b, c), to + 6 * stride);
        W::store(hn::And(both, c), to + 7 * stride);
    }

    template <std::size_t sites>
    HWY_INLINE void find_minterms(const State (&states)[sites]) {
        for (std::size_t i = 0; i < sites; ++i) {
            const State& s = states[i];
            products(s[0], s[2], s[4], even_ + i * lanes);
            products(s[1], s[3], s[5], odd_ + i * lanes);
            W::store(s[rest_bit], masks_.get() + offset(rest_mask) + i * lanes);
        }
        std::uint64_t* to = minterms_.get();
        for (const auto& c : configurations_) {
            for (std::size_t i = 0; i < sites; ++i) {
                W::store(
                    hn::And(W::load(even_ + c.even + i * lanes), W::load(odd_ + c.odd + i * lanes)),
                    to + i * lanes);
            }
            to += stride;
        }
    }

    template <std::size_t sites>
    HWY_INLINE void any_of(const std::vector<int>& configurations, V (&any)[sites]) const {
        for (auto& a : any)
            a = W::none();
        for (const int c : configurations) {
            for (std::size_t i = 0; i < sites; ++i) {
                any[i] = hn::Or(any[i], W::load(minterms_.get() + offset(c) + i * lanes));
            }
        }
    }

    template <std::size_t sites, class Source, class Counters>
    HWY_INLINE void decide_all(const Source& source, const Counters (&counters)[sites]) {
        std::uint64_t* to = masks_.get() + offset(first_decision_mask);
        for (const auto& d : decisions_) {
            V either[sites], with_rest[sites], without_rest[sites], asking[sites], yes[sites];
            any_of<sites>(d.either, either);
            any_of<sites>(d.with_rest, with_rest);
            any_of<sites>(d.without_rest, without_rest);
            V any = W::none();
            for (std::size_t i = 0; i < sites; ++i) {
                const V rest = mask(offset(rest_mask), i);
                asking[i] = hn::Or(either[i], W::choose(rest, with_rest[i], without_rest[i]));
                any = hn::Or(any, asking[i]);
                yes[i] = W::none();
            }
            if (!W::is_zero(any)) {
                Counters first[sites];
                for (std::size_t i = 0; i < sites; ++i) {
                    first[i] = Source::later(counters[i], static_cast<std::uint64_t>(32 * d.stage));
                }
                decide<W, sites>(source, first, d.below, asking, yes);
            }
            for (std::size_t i = 0; i < sites; ++i)
                W::store(yes[i], to + i * lanes);
            to += stride;
        }
    }

    template <std::size_t sites>
    HWY_INLINE void compute_masks() {
        // Local copies: the compiler cannot know that the words stored here are no pointers.
        std::uint64_t* const masks = masks_.get();
        std::uint64_t* to = masks + first_computed_;
        const Computed* const end = computed_.data() + computed_.size();
        for (const Computed* m = computed_.data(); m != end; ++m) {
            const std::uint64_t* const variable = masks + m->variable;
            const std::uint64_t* const yes = masks + m->yes;
            const std::uint64_t* const no = masks + m->no;
            for (std::size_t i = 0; i < sites; ++i) {
                W::store(W::choose(W::load(variable + i * lanes), W::load(yes + i * lanes),
                                   W::load(no + i * lanes)),
                         to + i * lanes);
            }
            to += stride;
        }
    }

    /// Applies all flips to one site; true if there are excess rests.
    HWY_INLINE bool change(State& state, std::size_t site, std::uint64_t* excess) const {
        const std::uint64_t* const masks = masks_.get() + site * lanes;
        const std::uint64_t* minterm = minterms_.get() + site * lanes;
        V made[excess_outputs];
        for (auto& m : made)
            m = W::none();
        const Configuration* const end = configurations_.data() + configurations_.size();
        for (const Configuration* c = configurations_.data(); c != end; ++c) {
            const V m = W::load(minterm);
            minterm += stride;
#pragma GCC unroll 7
            for (std::size_t o = 0; o < flip_outputs; ++o) {
                state[o] = hn::Xor(state[o], hn::And(m, W::load(masks + c->masks[o])));
            }
            if (!c->has_excess) continue;
#pragma GCC unroll 6
            for (std::size_t o = 0; o < excess_outputs; ++o) {
                made[o] = hn::Xor(made[o], hn::And(m, W::load(masks + c->masks[flip_outputs + o])));
            }
        }
        V any = W::none();
        for (const auto& m : made)
            any = hn::Or(any, m);
        if (W::is_zero(any)) return false;
        for (std::size_t o = 0; o < excess_outputs; ++o)
            W::store(made[o], excess + o * lanes);
        return true;
    }

    std::vector<PlannedDecision> decisions_;
    std::vector<Computed> computed_;
    std::vector<Configuration> configurations_;
    Offset first_computed_;
    AlignedWords masks_, minterms_;
    alignas(64) std::uint64_t even_[8 * stride];
    alignas(64) std::uint64_t odd_[8 * stride];
};

}  // namespace crossgrain::lga::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
