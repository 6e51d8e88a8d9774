// Measurements of the bit-sliced engine: sums over bins, for every replica.
#if defined(CROSSGRAIN_LGA_SLICED_BINS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROSSGRAIN_LGA_SLICED_BINS_INL
#undef CROSSGRAIN_LGA_SLICED_BINS_INL
#else
#define CROSSGRAIN_LGA_SLICED_BINS_INL
#endif

#include "native/lga/ensemble.hpp"
#include "native/lga/lane_counter-inl.hpp"
#include "native/lga/sliced_lattice.hpp"
#include "native/lga/sliced_relocation-inl.hpp"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace crossgrain::lga::HWY_NAMESPACE {

inline unsigned bit_of(const std::uint64_t* word, int i) {
    return static_cast<unsigned>(word[i / 64] >> (i % 64) & 1U);
}

template <std::size_t lanes>
class SlicedBins {
  public:
    using W = Words<lanes>;
    using V = typename W::V;

    SlicedBins(const Geometry& geometry, const SlicedLattice& lattice, int bin)
        : geometry_(geometry), lattice_(lattice), bin_(bin) {}

    /// Bin `b` of the first `replicas` replicas goes to the arrays from place `at` on.
    void measure(int b, const Fields& fields, std::size_t at, std::size_t replicas,
                 BinValues& values) const {
        LaneCounter<W, 17> count, rests, down, up;
        const int end = (b + 1) * bin_;
        for (int column = 0; column < geometry_.columns(); ++column) {
            for (int row = b * bin_; row < end; row += Short::capacity) {
                const int last = std::min(end, row + Short::capacity);
                if (fields.count) count.add(count_particles(column, row, last).digits());
                if (fields.rests) rests.add(count_rests(column, row, last).digits());
                if (fields.momentum) {
                    down.add(count_momentum(column, row, last, {0, 1, 5}).digits());
                    up.add(count_momentum(column, row, last, {3, 2, 4}).digits());
                }
            }
        }
        if (fields.count) std::copy_n(count.counts().begin(), replicas, &values.count[at]);
        if (fields.rests) std::copy_n(rests.counts().begin(), replicas, &values.rests[at]);
        if (fields.momentum) {
            const auto plus = down.counts(), minus = up.counts();
            for (std::size_t r = 0; r < replicas; ++r) {
                values.momentum[at + r] = static_cast<std::int16_t>(plus[r] - minus[r]);
            }
        }
    }

    /// Rests that found no place, at the end of a saturated run.
    void add_excess(int b, const SlicedRelocation<lanes>& relocation, const Fields& fields,
                    std::size_t at, int replicas, BinValues& values) const {
        for (int column = 1; column + 1 < geometry_.columns(); ++column) {
            for (int row = b * bin_; row < (b + 1) * bin_; ++row) {
                const auto* digits =
                    relocation.excess(geometry_.index({.column = column, .row = row}));
                for (int r = 0; r < replicas; ++r) {
                    unsigned more = 0;
                    for (std::size_t k = 0; k < relocation.digits; ++k) {
                        more |= bit_of(digits + k * lanes, r) << k;
                    }
                    const auto add = [&](std::uint16_t& value) {
                        value = static_cast<std::uint16_t>(value + more);
                    };
                    const auto place = at + static_cast<std::size_t>(r);
                    if (fields.count) add(values.count[place]);
                    if (fields.rests) add(values.rests[place]);
                }
            }
        }
    }

  private:
    using Short = ShortCounter<W>;

    HWY_INLINE V load(int state, int column, int row) const {
        return W::load(lattice_.word(state, {.column = column, .row = row}));
    }

    /// All particles of rows [first, last) of a column.
    Short count_particles(int column, int first, int last) const {
        Short count;
        for (int row = first; row < last; ++row) {
            V s[flip_outputs];
            for (int i = 0; i <= rest_bit; ++i)
                s[i] = load(i, column, row);
            const V x = sum_of(s[0], s[1], s[2]), y = sum_of(s[3], s[4], s[5]);
            const V cx = carry_of(s[0], s[1], s[2]), cy = carry_of(s[3], s[4], s[5]),
                    cz = carry_of(x, y, s[rest_bit]);
            count.add(sum_of(x, y, s[rest_bit]), sum_of(cx, cy, cz), carry_of(cx, cy, cz));
        }
        return count;
    }
    Short count_rests(int column, int first, int last) const {
        Short count;
        for (int row = first; row < last; ++row) {
            count.add(load(rest_bit, column, row), W::none(), W::none());
        }
        return count;
    }
    /// Half sites per step of a vertical direction (two) and of two diagonals (one each).
    Short count_momentum(int column, int first, int last, const std::array<int, 3>& along) const {
        Short count;
        for (int row = first; row < last; ++row) {
            const V vertical = load(along[0], column, row);
            const V one = load(along[1], column, row), other = load(along[2], column, row);
            const V two = hn::And(one, other);
            count.add(hn::Xor(one, other), hn::Xor(vertical, two), hn::And(vertical, two));
        }
        return count;
    }

    const Geometry& geometry_;
    const SlicedLattice& lattice_;
    int bin_;
};

}  // namespace crossgrain::lga::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
