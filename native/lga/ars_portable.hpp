// ARS4x32-7 in plain C++, for processors without AES rounds. Random123's ars.h is the definition.
#pragma once

#include "native/lga/random_bits.hpp"

#include <array>
#include <cstdint>

namespace crossgrain::lga {

/// One block of 128 bits: the same as with AES instructions.
[[nodiscard]] std::array<std::uint64_t, 2> portable_block(const RoundKeys& keys, Counter counter);

}  // namespace crossgrain::lga
