// Collisions and the gravity of the diagonals along a column, by whichever collision code fits the
// table.
#if defined(CROSSGRAIN_LGA_COLUMN_KERNEL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROSSGRAIN_LGA_COLUMN_KERNEL_INL
#undef CROSSGRAIN_LGA_COLUMN_KERNEL_INL
#else
#define CROSSGRAIN_LGA_COLUMN_KERNEL_INL
#endif

#include "native/lga/excess_list-inl.hpp"
#include "native/lga/sliced_collision-inl.hpp"

#include <memory>

HWY_BEFORE_NAMESPACE();
namespace crossgrain::lga::HWY_NAMESPACE {

/// Words of successive sites, by state.
using ColumnWords = std::array<std::uint64_t*, flip_outputs>;

template <std::size_t lanes>
class ColumnKernel {
  public:
    virtual ~ColumnKernel() = default;
    ColumnKernel(const ColumnKernel&) = delete;
    ColumnKernel& operator=(const ColumnKernel&) = delete;

    /// The interior sites with indices [first, last); excess rests go to `excess`.
    virtual void operator()(std::int64_t step, int first, int last, ColumnWords words,
                            ExcessList<lanes>& excess) = 0;
    /// Code of a table that the compiler knew, not an interpreter.
    [[nodiscard]] virtual bool is_compiled() const = 0;

  protected:
    ColumnKernel() = default;
};

template <std::size_t lanes, class Collision, class Source = SourceOf<lanes>>
class ColumnKernelOf final : public ColumnKernel<lanes> {
  public:
    using W = Words<lanes>;
    using V = typename W::V;
    using Counters = typename Source::Counters;
    using State = typename Collision::State;

    ColumnKernelOf(const Model& model, const CollisionPlan& plan, const Source& source)
        : collision_(plan), source_(source), gravity_(fixed_point(model.gravity)),
          up_diagonals_(model.gravity_rule.up_diagonals) {}

    void operator()(std::int64_t step, int first, int last, ColumnWords words,
                    ExcessList<lanes>& excess) override {
        constexpr int batch = static_cast<int>(Collision::batch);
        int index = first;
        Counters counters = source_.at(step, static_cast<std::uint32_t>(first));
        for (; index + batch <= last; index += batch) {
            collide<batch>(counters, index, words, excess);
        }
        for (; index < last; ++index)
            collide<1>(counters, index, words, excess);
    }
    [[nodiscard]] bool is_compiled() const override { return Collision::is_compiled; }

  private:
    template <std::size_t sites>
    HWY_INLINE void collide(Counters& next, int index, ColumnWords& words,
                            ExcessList<lanes>& excess) {
        State states[sites];
        Counters counters[sites];
        for (std::size_t i = 0; i < sites; ++i) {
            counters[i] = next;
            next = Source::next_site(next);
            for (std::size_t s = 0; s < flip_outputs; ++s) {
                states[i][s] = W::load(words[s] + i * lanes);
            }
        }
        collision_(
            states, source_, counters, [&] { return excess.next(); },
            [&](std::size_t i) { excess.add(index + static_cast<int>(i)); });
        if (up_diagonals_) {
            kick<sites>(states, 2, 1, Draw::right_kick, counters);
            kick<sites>(states, 4, 5, Draw::left_kick, counters);
        }
        for (std::size_t s = 0; s < flip_outputs; ++s) {
            for (std::size_t i = 0; i < sites; ++i)
                W::store(states[i][s], words[s] + i * lanes);
            words[s] += sites * lanes;
        }
    }

    /// One kick of gravity, into a state that is empty.
    template <std::size_t sites>
    HWY_INLINE void kick(State (&states)[sites], std::size_t from, std::size_t to, Draw draw,
                         const Counters (&counters)[sites]) const {
        V asking[sites], kicked[sites];
        Counters first[sites];
        for (std::size_t i = 0; i < sites; ++i) {
            asking[i] = W::without(states[i][from], states[i][to]);
            first[i] = Source::later(counters[i], static_cast<std::uint64_t>(draw));
        }
        decide<W, sites>(source_, first, gravity_, asking, kicked);
        for (std::size_t i = 0; i < sites; ++i) {
            states[i][from] = hn::Xor(states[i][from], kicked[i]);
            states[i][to] = hn::Xor(states[i][to], kicked[i]);
        }
    }

    Collision collision_;
    Source source_;
    std::uint32_t gravity_;
    bool up_diagonals_;
};

/// Kernels of tables that the compiler knows, or null if the actual plan is another one. Each table
/// is a file of its own, compiled_<reading>.cpp.
template <std::size_t lanes>
using CompiledKernel = std::unique_ptr<ColumnKernel<lanes>>(const Model& model,
                                                            const CollisionPlan& actual,
                                                            const SourceOf<lanes>& source);
template <std::size_t lanes>
CompiledKernel<lanes> compiled_p;
template <std::size_t lanes>
CompiledKernel<lanes> compiled_d;
template <std::size_t lanes>
CompiledKernel<lanes> compiled_m;
template <std::size_t lanes>
CompiledKernel<lanes> compiled_std;

/// Code if the table is one of these, else an interpreter.
template <std::size_t lanes>
[[nodiscard]] std::unique_ptr<ColumnKernel<lanes>> column_kernel(const Model& model,
                                                                 const SourceOf<lanes>& source) {
    const CollisionPlan actual = plan(compile(model), model.relocation);
    if constexpr (lanes > 1) {  // wider words are always faster where there are any
        for (auto* const compiled :
             {compiled_p<lanes>, compiled_d<lanes>, compiled_m<lanes>, compiled_std<lanes>}) {
            if (auto kernel = compiled(model, actual, source)) return kernel;
        }
    }
    return std::make_unique<ColumnKernelOf<lanes, SlicedCollision<lanes>>>(model, actual, source);
}

}  // namespace crossgrain::lga::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
