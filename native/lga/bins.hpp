// The arrays that measurements fill.
#pragma once

#include "native/lga/ensemble.hpp"

#include <cstddef>

namespace crossgrain::lga {

/// Zeros of shape (bins, replicas) for what is asked for, nothing for the rest.
inline void clear(BinValues& values, const Fields& fields, int bins, int replicas) {
    const auto size = static_cast<std::size_t>(bins) * static_cast<std::size_t>(replicas);
    values.count.assign(fields.count ? size : 0, 0);
    values.rests.assign(fields.rests ? size : 0, 0);
    values.momentum.assign(fields.momentum ? size : 0, 0);
}

}  // namespace crossgrain::lga
