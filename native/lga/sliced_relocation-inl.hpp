// Relocation of the rest particles beyond one per site in all replicas of a word; the rounds are
// those of relocation_limits.hpp.
#if defined(CROSSGRAIN_LGA_SLICED_RELOCATION_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROSSGRAIN_LGA_SLICED_RELOCATION_INL
#undef CROSSGRAIN_LGA_SLICED_RELOCATION_INL
#else
#define CROSSGRAIN_LGA_SLICED_RELOCATION_INL
#endif

#include "native/lga/excess_list-inl.hpp"
#include "native/lga/lane_counter-inl.hpp"
#include "native/lga/relocation_limits.hpp"
#include "native/lga/words-inl.hpp"

#include <stdexcept>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace crossgrain::lga::HWY_NAMESPACE {

template <std::size_t lanes>
class SlicedRelocation {
  public:
    using W = Words<lanes>;
    using V = typename W::V;
    using Source = SourceOf<lanes>;

    /// `rests`: the words of the rest particles, by site index.
    SlicedRelocation(const Geometry& geometry, Relocation relocation, std::uint64_t* rests)
        : geometry_(geometry), relocation_(relocation), rests_(rests), excess_(allocate(digits)),
          arrivals_(allocate(arrival_digits)),
          listed_(static_cast<std::size_t>(geometry.sites()), 0) {
        for (int column = 0; column < geometry.columns(); ++column) {
            for (int row = 0; row < geometry.rows(); ++row) {
                for (int i = 0; i < directions; ++i) {
                    neighbours_.push_back(
                        geometry.is_wall(column)
                            ? -1
                            : geometry.interior_neighbour({.column = column, .row = row}, i));
                }
            }
        }
    }

    /// Finds places for all on the list, which is empty then. Returns the replicas in which this is
    /// impossible.
    [[nodiscard]] V operator()(const Source& source, std::int64_t step, ExcessList<lanes>& made) {
        for (std::size_t i = 0; i < made.sites().size(); ++i) {
            if (relocation_ == Relocation::origin_first) {
                return_to_origins(made.sites()[i], made.words(i));
            } else {
                pile(made.sites()[i], made.words(i));
            }
        }
        made.clear();
        V saturated = W::none();
        for (std::int64_t round = 0; !walkers_.empty(); ++round) {
            if (round == saturation_round) saturated = more_rests_than_sites();
            if (round == max_rounds(geometry_)) saturated = hn::Or(saturated, walking());
            if (round >= saturation_round && W::is_zero(W::without(walking(), saturated))) break;
            depart(source, step, round, saturated);
            arrive();
        }
        release();
        return saturated;
    }

    /// Excess rests of a site in binary, `digits` words; 0 unless saturated.
    static constexpr std::size_t digits = 6;
    [[nodiscard]] const std::uint64_t* excess(int site) const {
        return excess_.get() + static_cast<std::size_t>(site) * digits * lanes;
    }

  private:
    static constexpr std::size_t arrival_digits = 3;
    static constexpr std::size_t count_digits = 28;

    [[nodiscard]] AlignedWords allocate(std::size_t words) const {
        const std::size_t size = (static_cast<std::size_t>(geometry_.sites()) + 1) * words * lanes;
        auto memory = aligned_words(size);
        std::fill_n(memory.get(), size, 0U);
        return memory;
    }
    [[nodiscard]] HWY_INLINE std::uint64_t* rest(int site) const {
        return rests_ + static_cast<std::size_t>(site) * lanes;
    }
    [[nodiscard]] HWY_INLINE std::uint64_t* excess_digits(int site) const {
        return excess_.get() + static_cast<std::size_t>(site) * digits * lanes;
    }
    [[nodiscard]] HWY_INLINE std::uint64_t* arrival_digits_of(int site) const {
        return arrivals_.get() + static_cast<std::size_t>(site) * arrival_digits * lanes;
    }
    HWY_INLINE void list(int site, std::vector<int>& on) {
        auto& flag = listed_[static_cast<std::size_t>(site)];
        if (flag) return;
        flag = 1;
        on.push_back(site);
    }

    /// Adds one where `carry` is set.
    static HWY_INLINE void increment(std::uint64_t* number, std::size_t size, V carry) {
        for (std::size_t k = 0; k < size; ++k) {
            const V digit = W::load(number + k * lanes);
            W::store(hn::Xor(digit, carry), number + k * lanes);
            carry = hn::And(digit, carry);
            if (W::is_zero(carry)) return;
        }
        throw std::logic_error("lattice gas: too many rest particles walk at one site");
    }
    static HWY_INLINE void decrement(std::uint64_t* number, std::size_t size, V borrow) {
        for (std::size_t k = 0; k < size && !W::is_zero(borrow); ++k) {
            const V digit = W::load(number + k * lanes);
            W::store(hn::Xor(digit, borrow), number + k * lanes);
            borrow = W::without(borrow, digit);
        }
    }
    [[nodiscard]] HWY_INLINE V nonzero(const std::uint64_t* number) const {
        V any = W::load(number);
        for (std::size_t k = 1; k < digits; ++k)
            any = hn::Or(any, W::load(number + k * lanes));
        return any;
    }
    /// Replicas in which some rests still walk.
    [[nodiscard]] V walking() const {
        V any = W::none();
        for (const int site : walkers_)
            any = hn::Or(any, nonzero(excess(site)));
        return any;
    }

    /// In the order of sites, then of directions. Who finds the origin taken walks on from its
    /// site.
    HWY_INLINE void return_to_origins(int site, const std::uint64_t* made) {
        for (std::size_t i = 0; i < directions; ++i) {
            V back = W::load(made + i * lanes);
            if (W::is_zero(back)) continue;
            const int target = neighbours_[static_cast<std::size_t>(site) * directions + i];
            if (target >= 0) {
                const V taken = W::load(rest(target));
                W::store(hn::Or(taken, back), rest(target));
                back = hn::And(back, taken);
                if (W::is_zero(back)) continue;
            }
            increment(excess_digits(site), digits, back);
            list(site, walkers_);
        }
    }

    HWY_INLINE void pile(int site, const std::uint64_t* made) {
        for (std::size_t k = 0; k < 3; ++k) {
            W::store(W::load(made + k * lanes), excess_digits(site) + k * lanes);
        }
        list(site, walkers_);
    }

    /// One excess rest of every site, except in replicas that are `held`, goes to a neighbour or
    /// waits.
    HWY_INLINE void depart(const Source& source, std::int64_t step, std::int64_t round, V held) {
        const std::size_t departing = walkers_.size();
        for (std::size_t w = 0; w < departing; ++w) {
            const int site = walkers_[w];
            const V has = W::without(nonzero(excess(site)), held);
            const auto counters = Source::later(source.at(step, static_cast<std::uint32_t>(site)),
                                                static_cast<std::uint64_t>(Draw::hop) +
                                                    static_cast<std::uint64_t>(3 * round));
            const V a = source(counters), b = source(Source::later(counters, 1)),
                    c = source(Source::later(counters, 2));
            const V low = W::without(has, a), high = W::without(hn::And(has, a), b);
            const V to[directions] = {hn::AndNot(b, W::without(low, c)),
                                      hn::AndNot(b, hn::And(low, c)),
                                      hn::And(b, W::without(low, c)),
                                      hn::And(b, hn::And(low, c)),
                                      W::without(high, c),
                                      hn::And(high, c)};
            V leaving = W::none();
            for (std::size_t i = 0; i < directions; ++i) {
                const int target = neighbours_[static_cast<std::size_t>(site) * directions + i];
                if (target < 0 || W::is_zero(to[i])) continue;
                leaving = hn::Or(leaving, to[i]);
                increment(arrival_digits_of(target), arrival_digits, to[i]);
                list(target, walkers_);
            }
            decrement(excess_digits(site), digits, leaving);
        }
    }

    /// Of those that arrive at a site without a rest particle one settles. Keeps the list of sites
    /// from which some walk on.
    HWY_INLINE void arrive() {
        std::size_t kept = 0;
        for (const int site : walkers_) {
            std::uint64_t* arriving = arrival_digits_of(site);
            std::uint64_t* walk_on = excess_digits(site);
            const V any = hn::Or(hn::Or(W::load(arriving), W::load(arriving + lanes)),
                                 W::load(arriving + 2 * lanes));
            if (!W::is_zero(any)) {
                const V taken = W::load(rest(site));
                W::store(hn::Or(taken, any), rest(site));
                decrement(arriving, arrival_digits, W::without(any, taken));
                add_arrivals(walk_on, arriving);
            }
            if (W::is_zero(nonzero(walk_on))) {
                listed_[static_cast<std::size_t>(site)] = 0;
            } else {
                walkers_[kept++] = site;
            }
        }
        walkers_.resize(kept);
    }

    static HWY_INLINE void add_arrivals(std::uint64_t* walk_on, std::uint64_t* arriving) {
        V carry = W::none();
        for (std::size_t k = 0; k < digits; ++k) {
            const V old = W::load(walk_on + k * lanes);
            V more = W::none();
            if (k < arrival_digits) {
                more = W::load(arriving + k * lanes);
                W::store(W::none(), arriving + k * lanes);
            } else if (W::is_zero(carry)) {
                return;
            }
            const V half = hn::Xor(old, more);
            W::store(hn::Xor(half, carry), walk_on + k * lanes);
            carry = hn::Or(hn::And(old, more), hn::And(half, carry));
        }
        if (!W::is_zero(carry)) {
            throw std::logic_error("lattice gas: too many rest particles walk at one site");
        }
    }

    /// Of the replicas that are not done.
    [[nodiscard]] V more_rests_than_sites() const {
        LaneCounter<W, count_digits> count;
        for (int site = geometry_.rows(); site < geometry_.sites() - geometry_.rows(); ++site) {
            const V at_rest[1] = {W::load(rest(site))};
            count.add(at_rest);
        }
        for (const int site : walkers_) {
            V more[digits];
            for (std::size_t k = 0; k < digits; ++k)
                more[k] = W::load(excess(site) + k * lanes);
            count.add(more);
        }
        alignas(64) std::uint64_t saturated[lanes] = {};
        for (std::size_t r = 0; r < 64 * lanes; ++r) {
            if (count[r] > geometry_.interior_sites()) {
                saturated[r / 64] |= std::uint64_t{1} << (r % 64);
            }
        }
        return hn::And(W::load(saturated), walking());
    }

    void release() {
        for (const int site : walkers_)
            listed_[static_cast<std::size_t>(site)] = 0;
        walkers_.clear();
    }

    Geometry geometry_;
    Relocation relocation_;
    std::uint64_t* rests_;
    AlignedWords excess_, arrivals_;
    std::vector<int> neighbours_;       ///< shape (sites, directions), -1: none
    std::vector<int> walkers_;          ///< sites with excess rests
    std::vector<std::uint8_t> listed_;  ///< is on walkers_
};

}  // namespace crossgrain::lga::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
