// Counts per replica, from words with one replica per bit.
#if defined(CROSSGRAIN_LGA_LANE_COUNTER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROSSGRAIN_LGA_LANE_COUNTER_INL
#undef CROSSGRAIN_LGA_LANE_COUNTER_INL
#else
#define CROSSGRAIN_LGA_LANE_COUNTER_INL
#endif

#include "native/lga/words-inl.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace crossgrain::lga::HWY_NAMESPACE {

/// Sum and carry of three bits.
template <class V>
HWY_INLINE V sum_of(V a, V b, V c) {
    return hn::Xor(a, hn::Xor(b, c));
}
template <class V>
HWY_INLINE V carry_of(V a, V b, V c) {
    return hn::Or(hn::And(a, b), hn::And(c, hn::Xor(a, b)));
}

/// Counts below 2^8, in registers: plane k holds bit k of every count.
template <class W>
class ShortCounter {
  public:
    using V = typename W::V;
    static constexpr std::size_t planes = 8;
    /// So many numbers of up to 7 can be added.
    static constexpr int capacity = 255 / 7;

    HWY_INLINE ShortCounter() {
        for (auto& plane : planes_)
            plane = W::none();
    }
    /// Adds the number with these three bits.
    HWY_INLINE void add(V ones, V twos, V fours) {
        V carry = hn::And(planes_[0], ones);
        planes_[0] = hn::Xor(planes_[0], ones);
        const V carry_1 = carry_of(planes_[1], twos, carry);
        planes_[1] = sum_of(planes_[1], twos, carry);
        carry = carry_of(planes_[2], fours, carry_1);
        planes_[2] = sum_of(planes_[2], fours, carry_1);
        for (std::size_t k = 3; k < planes; ++k) {
            const V next = hn::And(planes_[k], carry);
            planes_[k] = hn::Xor(planes_[k], carry);
            carry = next;
        }
    }
    [[nodiscard]] HWY_INLINE const V (&digits() const)[planes] { return planes_; }

  private:
    V planes_[planes];
};

/// Counts below 2^planes.
template <class W, std::size_t planes>
class LaneCounter {
  public:
    using V = typename W::V;

    LaneCounter() { std::memset(planes_, 0, sizeof(planes_)); }

    /// Adds the number with these bits.
    template <std::size_t size>
    HWY_INLINE void add(const V (&digits)[size]) {
        V carry = W::none();
        for (std::size_t k = 0; k < planes; ++k) {
            const V p = W::load(planes_[k]);
            if (k < size) {
                W::store(sum_of(p, digits[k], carry), planes_[k]);
                carry = carry_of(p, digits[k], carry);
            } else {
                W::store(hn::Xor(p, carry), planes_[k]);
                carry = hn::And(p, carry);
                if (W::is_zero(carry)) return;
            }
        }
    }
    [[nodiscard]] std::int64_t operator[](std::size_t replica) const {
        std::int64_t count = 0;
        for (std::size_t k = 0; k < planes; ++k) {
            count |= static_cast<std::int64_t>(planes_[k][replica / 64] >> (replica % 64) & 1U)
                     << k;
        }
        return count;
    }
    /// The counts of all replicas, modulo 2^16.
    [[nodiscard]] std::array<std::uint16_t, 64 * W::size> counts() const {
        std::array<std::uint16_t, 64 * W::size> all;
        for (std::size_t r = 0; r < all.size(); r += 4) {
            std::uint64_t four = 0;
            for (std::size_t k = 0; k < planes && k < 16; ++k) {
                // Four bits, each to a place 16 bits from the next.
                const std::uint64_t bits = planes_[k][r / 64] >> (r % 64) & 15U;
                four |= (bits * 0x0000200040008001U & 0x0001000100010001U) << k;
            }
            std::memcpy(&all[r], &four, sizeof(four));
        }
        return all;
    }

  private:
    alignas(64) std::uint64_t planes_[planes][W::size];
};

}  // namespace crossgrain::lga::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
