#include "native/lga/ars_portable.hpp"

#include <bit>

namespace crossgrain::lga {
namespace {

constexpr std::uint8_t doubled(std::uint8_t x) {
    return static_cast<std::uint8_t>((x << 1) ^ ((x >> 7) * 0x1B));
}

/// The S-box of AES (FIPS 197, 5.1.1): inverses in GF(2^8) by powers of the generator 3, then the
/// affine map.
constexpr std::array<std::uint8_t, 256> substitution() {
    std::array<std::uint8_t, 256> box{};
    std::uint8_t p = 1, q = 1;  // q = 1 / p
    do {
        p = static_cast<std::uint8_t>(p ^ doubled(p));
        for (int shift = 1; shift <= 4; shift *= 2)
            q = static_cast<std::uint8_t>(q ^ q << shift);
        if (q & 0x80) q ^= 0x09;
        const auto image =
            q ^ std::rotl(q, 1) ^ std::rotl(q, 2) ^ std::rotl(q, 3) ^ std::rotl(q, 4) ^ 0x63;
        box[p] = static_cast<std::uint8_t>(image);
    } while (p != 1);
    box[0] = 0x63;
    return box;
}

constexpr auto sbox = substitution();

/// SubBytes and MixColumns of one byte (FIPS 197, 5.1.3), as a column with byte 0 lowest.
constexpr std::array<std::uint32_t, 256> mixed_columns() {
    std::array<std::uint32_t, 256> table{};
    for (std::size_t x = 0; x < table.size(); ++x) {
        const std::uint32_t one = sbox[x], two = doubled(sbox[x]);
        table[x] = two | one << 8 | one << 16 | (two ^ one) << 24;
    }
    return table;
}

constexpr auto mixed = mixed_columns();

using Columns = std::array<std::uint32_t, 4>;

/// Byte `row` of the column that ShiftRows brings to `column`.
constexpr std::size_t shifted(const Columns& state, std::size_t column, unsigned row) {
    return state[(column + row) % 4] >> (8 * row) & 0xff;
}

Columns columns(const std::array<std::uint64_t, 2>& words) {
    return {static_cast<std::uint32_t>(words[0]), static_cast<std::uint32_t>(words[0] >> 32),
            static_cast<std::uint32_t>(words[1]), static_cast<std::uint32_t>(words[1] >> 32)};
}

Columns round(const Columns& state, const Columns& key) {
    Columns next = key;
    for (std::size_t c = 0; c < 4; ++c) {
        for (unsigned row = 0; row < 4; ++row) {
            next[c] ^= std::rotl(mixed[shifted(state, c, row)], static_cast<int>(8 * row));
        }
    }
    return next;
}

Columns last_round(const Columns& state, const Columns& key) {
    Columns next = key;
    for (std::size_t c = 0; c < 4; ++c) {
        for (unsigned row = 0; row < 4; ++row) {
            next[c] ^= static_cast<std::uint32_t>(sbox[shifted(state, c, row)]) << (8 * row);
        }
    }
    return next;
}

}  // namespace

std::array<std::uint64_t, 2> portable_block(const RoundKeys& keys, Counter counter) {
    Columns state = columns({counter.low ^ keys[0][0], counter.high ^ keys[0][1]});
    for (std::size_t i = 1; i < RoundKeys::rounds; ++i)
        state = round(state, columns(keys[i]));
    state = last_round(state, columns(keys[RoundKeys::rounds]));
    return {state[0] | std::uint64_t{state[1]} << 32, state[2] | std::uint64_t{state[3]} << 32};
}

}  // namespace crossgrain::lga
