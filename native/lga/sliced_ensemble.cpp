#include "native/lga/ensemble.hpp"

#include "native/lga/bins.hpp"

#include "native/lga/instruction_sets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "native/lga/sliced_ensemble.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "native/lga/sliced_block-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace crossgrain::lga::HWY_NAMESPACE {

/// Blocks side by side, one step of all after the other.
template <std::size_t lanes>
class SlicedEnsemble final : public Ensemble {
  public:
    using Block = SlicedBlock<lanes>;

    explicit SlicedEnsemble(const Model& model) : model_(model) {
        for (int first = 0; first < model.replicas; first += Block::width) {
            blocks_.push_back(std::make_unique<Block>(model, first));
        }
    }

    void advance(std::int64_t steps) override {
        for (; steps > 0 && saturated_.empty(); --steps) {
            bool any = false;
            for (auto& block : blocks_)
                any = block->advance() || any;
            ++step_;
            if (!any) continue;
            for (int r = 0; r < model_.replicas; ++r) {
                saturated_.push_back(block_of(r).is_saturated(r) ? 1 : 0);
            }
        }
    }
    [[nodiscard]] std::int64_t step() const override { return step_; }
    [[nodiscard]] const std::vector<std::uint8_t>& saturated() const override { return saturated_; }
    void measure(int bin, const Fields& fields, BinValues& values) const override {
        clear(values, fields, model_.length / bin, model_.replicas);
        for (const auto& block : blocks_)
            block->measure(bin, fields, values);
    }
    [[nodiscard]] std::uint8_t site(int replica, Site site) const override {
        return block_of(replica).site(replica, site);
    }
    [[nodiscard]] bool is_compiled() const override { return blocks_.front()->is_compiled(); }

  private:
    [[nodiscard]] const Block& block_of(int replica) const {
        return *blocks_[static_cast<std::size_t>(replica / Block::width)];
    }

    Model model_;
    std::vector<std::unique_ptr<Block>> blocks_;
    std::vector<std::uint8_t> saturated_;
    std::int64_t step_ = 0;
};

int widest_word() {
    constexpr std::size_t most = 64;  // bytes
    return 8 * static_cast<int>(std::min(most, hn::MaxLanes(hn::ScalableTag<std::uint8_t>())));
}

/// Null for a width that this target does not have.
Ensemble* sliced_ensemble(const Model& model, int word_bits) {
    if (word_bits == 64) return new SlicedEnsemble<1>(model);
#if HWY_MAX_BYTES >= 32
    if (word_bits == 256) return new SlicedEnsemble<4>(model);
#endif
#if HWY_MAX_BYTES >= 64
    if (word_bits == 512) return new SlicedEnsemble<8>(model);
#endif
    return nullptr;
}

}  // namespace crossgrain::lga::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <fmt/format.h>

#include <stdexcept>

namespace crossgrain::lga {

HWY_EXPORT(widest_word);
HWY_EXPORT(sliced_ensemble);

std::vector<int> word_widths() {
    const int widest = HWY_DYNAMIC_DISPATCH(widest_word)();
    std::vector<int> widths{64};
    for (const int bits : {256, 512}) {
        if (bits <= widest) widths.push_back(bits);
    }
    return widths;
}

int best_word_width(int replicas) {
    const auto widths = word_widths();
    // A site costs less in 256 bits than in 64: one vector instead of scalars.
    for (const int bits : widths) {
        if (bits >= replicas && bits > 64) return bits;
    }
    return widths.back();
}

std::unique_ptr<Ensemble> make_sliced_ensemble(const Model& model, int word_bits) {
    std::unique_ptr<Ensemble> made(HWY_DYNAMIC_DISPATCH(sliced_ensemble)(model, word_bits));
    if (made) return made;
    throw std::invalid_argument(fmt::format("this processor has no words of {} bits", word_bits));
}

}  // namespace crossgrain::lga
#endif
