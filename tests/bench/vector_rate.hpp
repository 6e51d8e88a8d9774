// How many vector instructions this processor does per second.
#pragma once

namespace crossgrain::bench {

/// Of the widest words that kernels are chosen with here, on one thread: products with sums,
/// differences, extrema and masks in equal parts, none of which waits for another. What a kernel
/// could reach at best, whatever the number and the width of the processor's units.
[[nodiscard]] double widest_vector_instructions_per_second();

}  // namespace crossgrain::bench
