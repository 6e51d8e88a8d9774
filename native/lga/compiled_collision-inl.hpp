// The collisions of neighbouring sites as code: the same as sliced_collision-inl.hpp, with a plan
// that the compiler knows.
#if defined(CROSSGRAIN_LGA_COMPILED_COLLISION_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROSSGRAIN_LGA_COMPILED_COLLISION_INL
#undef CROSSGRAIN_LGA_COMPILED_COLLISION_INL
#else
#define CROSSGRAIN_LGA_COMPILED_COLLISION_INL
#endif

#include "native/lga/column_kernel-inl.hpp"
#include "native/lga/compiled_plans.hpp"
#include "native/lga/words-inl.hpp"

#include <utility>

HWY_BEFORE_NAMESPACE();
namespace crossgrain::lga::HWY_NAMESPACE {

template <std::size_t lanes, const auto& plan>
class CompiledCollision {
  public:
    static constexpr bool is_compiled = true;
    static constexpr std::size_t batch = 2;
    using W = Words<lanes>;
    using V = typename W::V;
    using State = V[flip_outputs];  ///< movers 0..5, rest 6

    /// `actual` matches the plan; only the values of its probabilities are used.
    explicit CompiledCollision(const CollisionPlan& actual) {
        std::ranges::transform(actual.decisions, below_.begin(), &PlannedDecision::below);
    }

    /// As SlicedCollision.
    template <std::size_t sites, class Source, class Counters, class NextExcess, class Made>
    HWY_INLINE void operator()(State (&states)[sites], const Source& source,
                               const Counters (&counters)[sites], const NextExcess& next_excess,
                               const Made& made) const {
        static_assert(sites <= batch);
        V yes[sites][decisions];
        decide_all<sites>(states, source, counters, yes, std::make_index_sequence<decisions>());
        for (std::size_t i = 0; i < sites; ++i) {
            if (change(states[i], yes[i], next_excess())) made(i);
        }
    }

  private:
    static constexpr std::size_t configurations = plan.configurations.size();
    static constexpr std::size_t decisions = plan.decisions.size();
    static constexpr std::size_t computed = plan.masks.size();
    static constexpr std::size_t mask_count = plan.first_computed + computed;

    /// Products of three states or their complements; the first is the lowest bit.
    static HWY_INLINE void products(V a, V b, V c, V (&to)[8]) {
        const V neither = hn::AndNot(a, hn::Not(b)), only_a = W::without(a, b);
        const V only_b = W::without(b, a), both = hn::And(a, b);
        const V pairs[4] = {neither, only_a, only_b, both};
        for (std::size_t i = 0; i < 4; ++i) {
            to[i] = W::without(pairs[i], c);
            to[i + 4] = hn::And(pairs[i], c);
        }
    }

    struct Products {
        V even[8], odd[8];
        explicit HWY_INLINE Products(const State& s) {
            products(s[0], s[2], s[4], even);
            products(s[1], s[3], s[5], odd);
        }
        template <std::size_t c>
        [[nodiscard]] HWY_INLINE V minterm() const {
            constexpr auto& configuration = plan.configurations[c];
            return hn::And(even[configuration.even], odd[configuration.odd]);
        }
    };

    template <std::uint64_t set, std::size_t... c>
    static HWY_INLINE V any_of(const Products& products, std::index_sequence<c...> /*all*/) {
        V any = W::none();
        const auto add = [&]<std::size_t i>() {
            if constexpr ((set >> i & 1U) != 0) {
                any = hn::Or(any, products.template minterm<i>());
            }
        };
        (add.template operator()<c>(), ...);
        return any;
    }

    /// The replicas that ask for a decision.
    template <std::size_t k>
    static HWY_INLINE V asking(const Products& products, V rest) {
        constexpr auto& d = plan.decisions[k];
        constexpr auto all = std::make_index_sequence<configurations>();
        V any = any_of<d.either>(products, all);
        if constexpr (d.with_rest != 0) {
            any = hn::Or(any, hn::And(any_of<d.with_rest>(products, all), rest));
        }
        if constexpr (d.without_rest != 0) {
            any = hn::Or(any, W::without(any_of<d.without_rest>(products, all), rest));
        }
        return any;
    }

    template <std::size_t sites, class Source, class Counters, std::size_t... k>
    HWY_INLINE void decide_all(const State (&states)[sites], const Source& source,
                               const Counters (&counters)[sites], V (&yes)[sites][decisions],
                               std::index_sequence<k...> /*all*/) const {
        V asked[decisions][sites];
        for (std::size_t i = 0; i < sites; ++i) {
            const Products products(states[i]);
            ((asked[k][i] = asking<k>(products, states[i][rest_bit])), ...);
        }
        (decide_one<k, sites>(source, counters, asked[k], yes), ...);
    }

    template <std::size_t k, std::size_t sites, class Source, class Counters>
    HWY_INLINE void decide_one(const Source& source, const Counters (&counters)[sites],
                               const V (&asked)[sites], V (&yes)[sites][decisions]) const {
        V less[sites];
        V any = asked[0];
        for (std::size_t i = 1; i < sites; ++i)
            any = hn::Or(any, asked[i]);
        for (auto& l : less)
            l = W::none();
        if (!W::is_zero(any)) {
            Counters first[sites];
            for (std::size_t i = 0; i < sites; ++i) {
                first[i] = Source::later(counters[i],
                                         static_cast<std::uint64_t>(32 * plan.decisions[k].stage));
            }
            decide<W, sites>(source, first, below_[k], asked, less);
        }
        for (std::size_t i = 0; i < sites; ++i)
            yes[i][k] = less[i];
    }

    /// mask = variable ? yes : no, where one of them may be constant.
    template <std::size_t i>
    static HWY_INLINE void compute(V (&masks)[mask_count]) {
        constexpr PlannedMask m = plan.masks[i];
        const V variable = masks[m.variable], yes = masks[m.yes], no = masks[m.no];
        V& mask = masks[static_cast<std::size_t>(plan.first_computed) + i];
        if constexpr (m.yes == never_mask) {
            mask = W::without(no, variable);
        } else if constexpr (m.no == never_mask) {
            mask = hn::And(variable, yes);
        } else if constexpr (m.yes == always_mask) {
            mask = hn::Or(variable, no);
        } else {
            mask = W::choose(variable, yes, no);
        }
    }

    template <int mask>
    static HWY_INLINE void flip(V& word, V minterm, const V (&masks)[mask_count]) {
        if constexpr (mask == always_mask) {
            word = hn::Xor(word, minterm);
        } else if constexpr (mask != never_mask) {
            word = hn::Xor(word, hn::And(minterm, masks[mask]));
        }
    }

    template <std::size_t c, std::size_t... o>
    static HWY_INLINE void apply(const Products& products, const V (&masks)[mask_count],
                                 V (&words)[outputs], std::index_sequence<o...> /*all*/) {
        const V minterm = products.template minterm<c>();
        (flip<plan.configurations[c].mask[o]>(words[o], minterm, masks), ...);
    }

    template <std::size_t... i>
    static HWY_INLINE void compute_all(V (&masks)[mask_count], std::index_sequence<i...> /*all*/) {
        (compute<i>(masks), ...);
    }
    template <std::size_t... c>
    static HWY_INLINE void apply_all(const Products& products, const V (&masks)[mask_count],
                                     V (&words)[outputs], std::index_sequence<c...> /*all*/) {
        (apply<c>(products, masks, words, std::make_index_sequence<outputs>()), ...);
    }

    /// Applies all flips to one site; true if there are excess rests.
    static HWY_INLINE bool change(State& state, const V (&yes)[decisions], std::uint64_t* excess) {
        V masks[mask_count];
        masks[never_mask] = W::none();
        masks[always_mask] = W::all();
        masks[rest_mask] = state[rest_bit];
        for (std::size_t k = 0; k < decisions; ++k)
            masks[first_decision_mask + k] = yes[k];
        compute_all(masks, std::make_index_sequence<computed>());
        V words[outputs];
        for (std::size_t o = 0; o < flip_outputs; ++o)
            words[o] = state[o];
        for (std::size_t o = flip_outputs; o < outputs; ++o)
            words[o] = W::none();
        const Products products(state);
        apply_all(products, masks, words, std::make_index_sequence<configurations>());
        for (std::size_t o = 0; o < flip_outputs; ++o)
            state[o] = words[o];
        V any = W::none();
        for (std::size_t o = flip_outputs; o < outputs; ++o)
            any = hn::Or(any, words[o]);
        if (W::is_zero(any)) return false;
        for (std::size_t o = 0; o < excess_outputs; ++o) {
            W::store(words[flip_outputs + o], excess + o * lanes);
        }
        return true;
    }

    std::array<std::uint32_t, decisions> below_{};
};

/// The kernel of this plan, or null if the actual one does not match it.
template <std::size_t lanes, const auto& compiled>
[[nodiscard]] std::unique_ptr<ColumnKernel<lanes>>
kernel_if_matching(const Model& model, const CollisionPlan& actual, const SourceOf<lanes>& source) {
    if (!compiled.matches(actual)) return nullptr;
    return std::make_unique<ColumnKernelOf<lanes, CompiledCollision<lanes, compiled>>>(
        model, actual, source);
}

}  // namespace crossgrain::lga::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
