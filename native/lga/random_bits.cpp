#include "native/lga/random_bits.hpp"

#include "native/lga/instruction_sets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "native/lga/random_bits.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "native/lga/bit_source-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace crossgrain::lga::HWY_NAMESPACE {

void four_blocks(const RoundKeys& keys, Counter first, Blocks& blocks) {
#if HWY_TARGET == HWY_SCALAR
    for (std::uint64_t i = 0; i < blocks.size(); ++i) {
        blocks[i] = portable_block(keys, {.low = first.low, .high = first.high + i});
    }
#else
    const hn::FixedTag<std::uint64_t, 2> d;
    const Ars<decltype(d)> ars(keys);
    for (std::uint64_t i = 0; i < blocks.size(); ++i) {
        alignas(16) const std::uint64_t lanes[2] = {first.low, first.high + i};
        hn::StoreU(ars(hn::Load(d, lanes)), d, blocks[i].data());
    }
#endif
}

}  // namespace crossgrain::lga::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace crossgrain::lga {

HWY_EXPORT(four_blocks);

RoundKeys::RoundKeys(std::uint64_t seed, RandomUse use) noexcept {
    // The golden ratio and sqrt(3) - 1, as in ars.h.
    constexpr std::array<std::uint64_t, 2> weyl{0x9E3779B97F4A7C15ULL, 0xBB67AE8584CAA73BULL};
    keys_[0] = {seed, static_cast<std::uint64_t>(use)};
    for (std::size_t i = 1; i < keys_.size(); ++i) {
        keys_[i] = {keys_[i - 1][0] + weyl[0], keys_[i - 1][1] + weyl[1]};
    }
}

Blocks random_blocks(const RoundKeys& keys, Counter first) {
    Blocks blocks;
    HWY_DYNAMIC_DISPATCH(four_blocks)(keys, first, blocks);
    return blocks;
}

}  // namespace crossgrain::lga
#endif
