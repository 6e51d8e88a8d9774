// Bytes as compact text, for pixels in JSON: deflated (zlib), then base64.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace crossgrain::store {

[[nodiscard]] std::string pack(const std::vector<std::uint8_t>& bytes);

/// Inverse of pack; `size` is the number of bytes that were packed.
/// @throws std::invalid_argument when the text is damaged or holds another number of bytes.
[[nodiscard]] std::vector<std::uint8_t> unpack(std::string_view text, std::size_t size);

}  // namespace crossgrain::store
