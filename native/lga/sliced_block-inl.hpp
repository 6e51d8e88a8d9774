// As many replicas as a word has bits, advanced together: each bit of a word is a replica. The
// steps are those of table_replica.cpp.
#if defined(CROSSGRAIN_LGA_SLICED_BLOCK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROSSGRAIN_LGA_SLICED_BLOCK_INL
#undef CROSSGRAIN_LGA_SLICED_BLOCK_INL
#else
#define CROSSGRAIN_LGA_SLICED_BLOCK_INL
#endif

#include "native/lga/column_kernel-inl.hpp"
#include "native/lga/initial_state.hpp"
#include "native/lga/profile.hpp"
#include "native/lga/sliced_bins-inl.hpp"
#include "native/lga/sliced_lattice.hpp"

HWY_BEFORE_NAMESPACE();
namespace crossgrain::lga::HWY_NAMESPACE {

template <std::size_t lanes>
class SlicedBlock {
  public:
    using W = Words<lanes>;
    using V = typename W::V;
    using Source = SourceOf<lanes>;
    using Counters = typename Source::Counters;
    static constexpr int width = 64 * static_cast<int>(lanes);

    /// Replicas `first` to first + width - 1, as far as the model has them.
    SlicedBlock(const Model& model, int first,
                std::unique_ptr<ColumnKernel<lanes>> kernel = nullptr)
        : model_(model), geometry_(model), first_(first),
          replicas_(std::min(width, model.replicas - first)),
          source_(RoundKeys(model.seed, RandomUse::dynamics), first / 64),
          lattice_(geometry_, lanes),
          kernel_(kernel ? std::move(kernel) : column_kernel<lanes>(model, source_)),
          excess_(geometry_.interior_sites()),
          relocation_(geometry_, model.relocation,
                      lattice_.word(rest_bit, {.column = 0, .row = 0})),
          gravity_(fixed_point(model.gravity)), roughness_(fixed_point(model.roughness)),
          injection_(fixed_point(model.injection)) {
        for (int r = 0; r < replicas_; ++r) {
            fill(r, initial_state(model, first + r));
            present_[r / 64] |= std::uint64_t{1} << (r % 64);
        }
    }

    [[nodiscard]] bool is_compiled() const { return kernel_->is_compiled(); }
    /// True if some replica is saturated by this step.
    [[nodiscard]] bool advance() {
        return advance([](Phase /*ended*/) {});
    }
    /// The same; `watch` is told when a phase has ended.
    template <class Watch>
    [[nodiscard]] bool advance(const Watch& watch) {
        for (const int wall : {0, geometry_.columns() - 1}) {
            for (const auto& run : lattice_.runs(wall))
                reflect(wall, run);
        }
        watch(Phase::reflection);
        for (int column = 1; column + 1 < geometry_.columns(); ++column) {
            for (const auto& run : lattice_.runs(column))
                collide(column, run);
        }
        watch(Phase::collision);
        const V saturated = relocation_(source_, step_, excess_);
        W::store(saturated, saturated_);
        watch(Phase::relocation);
        kick_vertically();
        watch(Phase::vertical_gravity);
        if (!model_.periodic) inject();
        lattice_.propagate(geometry_);
        if (!model_.periodic) clear_ends();
        ++step_;
        watch(Phase::propagation);
        return !W::is_zero(saturated);
    }

    [[nodiscard]] bool is_saturated(int replica) const {
        return bit_of(saturated_, replica - first_) != 0;
    }
    [[nodiscard]] std::uint8_t site(int replica, Site site) const {
        unsigned packed = 0;
        for (int i = 0; i <= rest_bit; ++i) {
            packed |= bit_of(lattice_.word(i, site), replica - first_) << i;
        }
        return static_cast<std::uint8_t>(packed);
    }

    /// Fills the part of the arrays that belongs to these replicas.
    void measure(int bin, const Fields& fields, BinValues& values) const {
        const SlicedBins<lanes> bins(geometry_, lattice_, bin);
        const std::size_t all = static_cast<std::size_t>(model_.replicas);
        for (int b = 0; b < geometry_.rows() / bin; ++b) {
            const auto at = static_cast<std::size_t>(b) * all + static_cast<std::size_t>(first_);
            bins.measure(b, fields, at, static_cast<std::size_t>(replicas_), values);
            if (!W::is_zero(W::load(saturated_))) {
                bins.add_excess(b, relocation_, fields, at, replicas_, values);
            }
        }
    }

  private:
    void fill(int r, const std::vector<std::uint8_t>& sites) {
        for (int column = 0; column < geometry_.columns(); ++column) {
            for (int row = 0; row < geometry_.rows(); ++row) {
                const Site site{.column = column, .row = row};
                const auto packed = sites[static_cast<std::size_t>(geometry_.index(site))];
                for (int i = 0; i <= rest_bit; ++i) {
                    lattice_.word(i, site)[r / 64] |= std::uint64_t{packed >> i & 1U} << (r % 64);
                }
            }
        }
    }

    /// Collisions, and the gravity of the diagonals, which relocation leaves alone.
    void collide(int column, const SlicedLattice::Run& run) {
        ColumnWords words;
        for (int i = 0; i <= rest_bit; ++i) {
            words[static_cast<std::size_t>(i)] =
                lattice_.word(i, {.column = column, .row = run.first});
        }
        const int start = geometry_.index({.column = column, .row = 0});
        (*kernel_)(step_, start + run.first, start + run.last, words, excess_);
    }

    /// See TableReplica::reflect_at.
    void reflect(int column, const SlicedLattice::Run& run) {
        const bool left = column == 0;
        const int up = left ? 4 : 2, down = left ? 5 : 1;
        for (int row = run.first; row < run.last; ++row) {
            const Site site{.column = column, .row = row};
            const auto counters =
                source_.at(step_, static_cast<std::uint32_t>(geometry_.index(site)));
            std::uint64_t* arriving_up = lattice_.word(up, site);
            std::uint64_t* arriving_down = lattice_.word(down, site);
            const V u = W::load(arriving_up), d = W::load(arriving_down);
            W::store(W::none(), arriving_up);
            W::store(W::none(), arriving_down);
            const V both = hn::And(u, d), single = hn::Xor(u, d);
            const V back = decide<W>(
                source_, Source::later(counters, static_cast<std::uint64_t>(Draw::reflection)),
                roughness_, single);
            // Of a single one: leaves downward if it came upward and bounces back, or if it came
            // downward and does not.
            const V downward = hn::And(single, hn::Not(hn::Xor(u, back)));
            V leaving_down = hn::Or(both, downward);
            V leaving_up = hn::Or(both, W::without(single, downward));
            if (model_.gravity_rule.on_walls && model_.gravity_rule.up_diagonals) {
                const Draw draw = left ? Draw::right_kick : Draw::left_kick;
                const V kicked =
                    decide<W>(source_, Source::later(counters, static_cast<std::uint64_t>(draw)),
                              gravity_, W::without(leaving_up, leaving_down));
                leaving_up = hn::Xor(leaving_up, kicked);
                leaving_down = hn::Xor(leaving_down, kicked);
            }
            W::store(leaving_down, lattice_.word(opposite(up), site));
            W::store(leaving_up, lattice_.word(opposite(down), site));
        }
    }

    /// Gravity between rest and the vertical movers.
    void kick_vertically() {
        const auto& rule = model_.gravity_rule;
        if (!rule.rest_to_down && !rule.up_to_rest) return;
        for (int column = 1; column + 1 < geometry_.columns(); ++column) {
            for (const auto& run : lattice_.runs(column)) {
                const Site start{.column = column, .row = run.first};
                std::uint64_t *down = lattice_.word(0, start), *up = lattice_.word(3, start),
                              *rest = lattice_.word(rest_bit, start);
                auto counters = Source::later(
                    source_.at(step_, static_cast<std::uint32_t>(geometry_.index(start))),
                    static_cast<std::uint64_t>(Draw::vertical_kick));
                for (int row = run.first; row < run.last; ++row) {
                    const V d = W::load(down), u = W::load(up), r = W::load(rest);
                    const V falls = rule.rest_to_down ? W::without(r, d) : W::none();
                    const V stops = rule.up_to_rest ? W::without(u, r) : W::none();
                    const V kicked = decide<W>(source_, counters, gravity_, hn::Or(falls, stops));
                    W::store(hn::Or(d, hn::And(kicked, falls)), down);
                    W::store(W::without(u, hn::And(kicked, stops)), up);
                    W::store(hn::Xor(r, kicked), rest);
                    down += lanes, up += lanes, rest += lanes;
                    counters = Source::next_site(counters);
                }
            }
        }
    }

    void inject() {
        const V present = W::load(present_);
        for (int column = 0; column < geometry_.columns(); ++column) {
            const Site site{.column = column, .row = 0};
            const auto counters =
                source_.at(step_, static_cast<std::uint32_t>(geometry_.index(site)));
            for (const int i : {0, 1, 5}) {
                if (!geometry_.is_fed(column, i)) continue;
                std::uint64_t* word = lattice_.word(i, site);
                const V old = W::load(word);
                const auto draws = static_cast<std::uint64_t>(Draw::injection) +
                                   static_cast<std::uint64_t>(32 * i);
                W::store(hn::Or(old, decide<W>(source_, Source::later(counters, draws), injection_,
                                               W::without(present, old))),
                         word);
            }
        }
    }

    /// What left an open pipe.
    void clear_ends() {
        for (int i = 0; i < directions; ++i) {
            for (int column = 0; column < geometry_.columns(); ++column) {
                const int from = column - Geometry::column_step(i);
                if (from < 0 || from >= geometry_.columns()) continue;
                const int step = geometry_.row_step(i, from);
                if (step == 0) continue;
                const int row = step > 0 ? 0 : geometry_.rows() - 1;
                W::store(W::none(), lattice_.word(i, {.column = column, .row = row}));
            }
        }
    }

    Model model_;
    Geometry geometry_;
    int first_, replicas_;
    Source source_;
    SlicedLattice lattice_;
    std::unique_ptr<ColumnKernel<lanes>> kernel_;
    ExcessList<lanes> excess_;
    SlicedRelocation<lanes> relocation_;
    std::uint32_t gravity_, roughness_, injection_;
    std::int64_t step_ = 0;
    alignas(64) std::uint64_t present_[lanes] = {};
    alignas(64) std::uint64_t saturated_[lanes] = {};
};

}  // namespace crossgrain::lga::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
