// Memory for vectors of words.
#pragma once

#include <hwy/aligned_allocator.h>

#include <cstddef>
#include <cstdint>
#include <new>

namespace crossgrain::lga {

using AlignedWords = hwy::AlignedFreeUniquePtr<std::uint64_t[]>;

/// Words that are not initialised. Throws std::bad_alloc, which Highway itself does not.
[[nodiscard]] inline AlignedWords aligned_words(std::size_t size) {
    auto words = hwy::AllocateAligned<std::uint64_t>(size);
    if (!words) throw std::bad_alloc();
    return words;
}

}  // namespace crossgrain::lga
