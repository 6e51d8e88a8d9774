#include "native/lga/profile.hpp"

#include "native/base/cpu_time.hpp"
#include "native/lga/bins.hpp"

#include "native/lga/instruction_sets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "native/lga/profile.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "native/lga/sliced_block-inl.hpp"

#include <bit>
#include <limits>
#include <stdexcept>

HWY_BEFORE_NAMESPACE();
namespace crossgrain::lga::HWY_NAMESPACE {
namespace {

double thread_cpu_ns() {
    return 1e9 * thread_cpu_seconds();
}

/// The usual words, counted.
template <std::size_t lanes>
class CountingSource {
  public:
    using Inner = SourceOf<lanes>;
    using V = typename Inner::V;
    using Counters = typename Inner::Counters;

    CountingSource(Inner inner, std::int64_t& words) : inner_(inner), words_(&words) {}
    [[nodiscard]] Counters at(std::int64_t step, std::uint32_t site) const {
        return inner_.at(step, site);
    }
    [[nodiscard]] static Counters next_site(Counters c) { return Inner::next_site(c); }
    [[nodiscard]] static Counters later(Counters c, std::uint64_t draws) {
        return Inner::later(c, draws);
    }
    [[nodiscard]] HWY_INLINE V operator()(Counters c) const {
        ++*words_;
        return inner_(c);
    }

  private:
    Inner inner_;
    std::int64_t* words_;
};

/// The interpreter, with the early exits of compiled code: decisions of two sites at a time.
template <std::size_t lanes>
class InPairs : public SlicedCollision<lanes> {
  public:
    using SlicedCollision<lanes>::SlicedCollision;
    static constexpr std::size_t batch = 2;
};

template <std::size_t lanes>
double count_words(const Model& model, std::int64_t warm_up, std::int64_t steps) {
    using Counting = CountingSource<lanes>;
    std::int64_t words = 0;
    const SourceOf<lanes> source(RoundKeys(model.seed, RandomUse::dynamics), 0);
    SlicedBlock<lanes> block(
        model, 0,
        std::make_unique<ColumnKernelOf<lanes, InPairs<lanes>, Counting>>(
            model, plan(compile(model), model.relocation), Counting(source, words)));
    for (std::int64_t i = 0; i < warm_up; ++i)
        (void)block.advance();
    words = 0;
    for (std::int64_t i = 0; i < steps; ++i)
        (void)block.advance();
    const double sites = static_cast<double>(model.length) * model.width;
    const auto& rule = model.gravity_rule;
    const bool vertical = rule.rest_to_down || rule.up_to_rest;
    return static_cast<double>(words) / (static_cast<double>(steps) * sites) +
           (vertical ? std::min(deciding_bits(fixed_point(model.gravity)), bits_before_exit) : 0);
}

template <std::size_t lanes>
double random_word_ns() {
    using W = Words<lanes>;
    constexpr int words = 4096;
    const SourceOf<lanes> source(RoundKeys(1, RandomUse::dynamics), 0);
    double best = std::numeric_limits<double>::infinity();
    auto all = W::none();
    for (int repeat = 0; repeat < 50; ++repeat) {
        const double start = thread_cpu_ns();
        auto counters = source.at(repeat, 0);
        for (int i = 0; i < words; ++i) {
            all = hn::Xor(all, source(counters));
            counters = SourceOf<lanes>::later(counters, 1);
        }
        best = std::min(best, (thread_cpu_ns() - start) / words);
    }
    if (W::is_zero(all)) throw std::logic_error("lattice gas: random words cancel");
    return best;
}

template <std::size_t lanes>
StepProfile profile_words(Model model, std::int64_t warm_up, std::int64_t steps, int repeats,
                          int bin) {
    model.replicas = SlicedBlock<lanes>::width;
    SlicedBlock<lanes> block(model, 0);
    for (std::int64_t i = 0; i < warm_up; ++i)
        (void)block.advance();
    const double per_step = static_cast<double>(model.length) * model.width;
    StepProfile best;
    best.phase_ns.fill(std::numeric_limits<double>::infinity());
    best.measurement_ns = std::numeric_limits<double>::infinity();
    for (int repeat = 0; repeat < repeats; ++repeat) {
        std::array<double, phases> spent{};
        double last = thread_cpu_ns();
        const auto watch = [&](Phase ended) {
            const double now = thread_cpu_ns();
            spent[static_cast<std::size_t>(ended)] += now - last;
            last = now;
        };
        for (std::int64_t i = 0; i < steps; ++i)
            (void)block.advance(watch);
        for (std::size_t i = 0; i < phases; ++i) {
            best.phase_ns[i] =
                std::min(best.phase_ns[i], spent[i] / (per_step * static_cast<double>(steps)));
        }
        BinValues values;
        last = thread_cpu_ns();
        clear(values, {}, model.length / bin, model.replicas);
        block.measure(bin, {}, values);
        best.measurement_ns = std::min(best.measurement_ns, (thread_cpu_ns() - last) / per_step);
    }
    best.words_per_site = count_words<lanes>(model, warm_up, 20);
    best.random_word_ns = random_word_ns<lanes>();
    return best;
}

template <std::size_t lanes>
double frequency_of(double probability, std::int64_t words) {
    using W = Words<lanes>;
    const SourceOf<lanes> source(RoundKeys(1, RandomUse::dynamics), 0);
    constexpr std::int64_t sites = 1000;
    std::int64_t yes = 0;
    for (std::int64_t step = 0; step < words / sites; ++step) {
        auto counters = source.at(step, 0);
        for (std::int64_t i = 0; i < sites; ++i) {
            alignas(64) std::uint64_t decided[lanes];
            W::store(decide<W>(source, counters, fixed_point(probability), W::all()), decided);
            for (const auto lane : decided)
                yes += std::popcount(lane);
            counters = SourceOf<lanes>::next_site(counters);
        }
    }
    return static_cast<double>(yes) /
           static_cast<double>(words / sites * sites * SlicedBlock<lanes>::width);
}

}  // namespace

/// NaN for a width that this target does not have.
double frequency_if_possible(double probability, int word_bits, std::int64_t words) {
    if (word_bits == 64) return frequency_of<1>(probability, words);
#if HWY_MAX_BYTES >= 32
    if (word_bits == 256) return frequency_of<4>(probability, words);
#endif
#if HWY_MAX_BYTES >= 64
    if (word_bits == 512) return frequency_of<8>(probability, words);
#endif
    return std::numeric_limits<double>::quiet_NaN();
}

/// False for a width that this target does not have.
bool profile_if_possible(const Model& model, int word_bits, std::int64_t warm_up,
                         std::int64_t steps, int repeats, int bin, StepProfile& result) {
    const auto run = [&]<std::size_t lanes>() {
        result = profile_words<lanes>(model, warm_up, steps, repeats, bin);
        return true;
    };
    if (word_bits == 64) return run.template operator()<1>();
#if HWY_MAX_BYTES >= 32
    if (word_bits == 256) return run.template operator()<4>();
#endif
#if HWY_MAX_BYTES >= 64
    if (word_bits == 512) return run.template operator()<8>();
#endif
    return false;
}

}  // namespace crossgrain::lga::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <fmt/format.h>

#include <stdexcept>

namespace crossgrain::lga {

HWY_EXPORT(frequency_if_possible);
HWY_EXPORT(profile_if_possible);

double frequency(double probability, int word_bits, std::int64_t words) {
    return HWY_DYNAMIC_DISPATCH(frequency_if_possible)(probability, word_bits, words);
}

StepProfile profile(const Model& model, int word_bits, std::int64_t warm_up, std::int64_t steps,
                    int repeats, int bin) {
    StepProfile result;
    if (HWY_DYNAMIC_DISPATCH(profile_if_possible)(model, word_bits, warm_up, steps, repeats, bin,
                                                  result)) {
        return result;
    }
    throw std::invalid_argument(fmt::format("this processor has no words of {} bits", word_bits));
}

}  // namespace crossgrain::lga
#endif
