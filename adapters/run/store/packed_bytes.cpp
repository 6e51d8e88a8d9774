#include "adapters/run/store/packed_bytes.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>
#include <zlib.h>

#include <limits>
#include <stdexcept>

namespace crossgrain::store {
namespace {

/// OpenSSL counts in int; a picture beyond that is a mistake.
int checked_length(std::size_t size) {
    if (size > static_cast<std::size_t>(std::numeric_limits<int>::max()) / 2)
        throw std::invalid_argument(fmt::format("{} bytes are too many to pack", size));
    return static_cast<int>(size);
}

std::string to_base64(const std::vector<std::uint8_t>& bytes) {
    const int length = checked_length(bytes.size());
    // EVP_EncodeBlock ends its text with a zero byte, which std::string has room for.
    std::string text(4 * ((bytes.size() + 2) / 3), '\0');
    EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()), bytes.data(), length);
    return text;
}

std::vector<std::uint8_t> from_base64(std::string_view text) {
    std::vector<std::uint8_t> bytes(3 * (text.size() / 4));
    const int decoded =
        EVP_DecodeBlock(bytes.data(), reinterpret_cast<const unsigned char*>(text.data()),
                        checked_length(text.size()));
    if (decoded < 0) throw std::invalid_argument("packed bytes are not base64");
    const std::size_t padding = text.ends_with("==") ? 2 : text.ends_with('=') ? 1 : 0;
    bytes.resize(static_cast<std::size_t>(decoded) - padding);
    return bytes;
}

}  // namespace

std::string pack(const std::vector<std::uint8_t>& bytes) {
    (void)checked_length(bytes.size());
    uLongf length = compressBound(static_cast<uLong>(bytes.size()));
    std::vector<std::uint8_t> deflated(length);
    const int status =
        compress(deflated.data(), &length, bytes.data(), static_cast<uLong>(bytes.size()));
    if (status != Z_OK) throw std::runtime_error("zlib could not pack bytes");
    deflated.resize(length);
    return to_base64(deflated);
}

std::vector<std::uint8_t> unpack(std::string_view text, std::size_t size) {
    const std::vector<std::uint8_t> deflated = from_base64(text);
    (void)checked_length(size);
    // One byte more than asked for, so that a longer content is noticed.
    std::vector<std::uint8_t> bytes(size + 1);
    uLongf length = static_cast<uLongf>(bytes.size());
    const int status =
        uncompress(bytes.data(), &length, deflated.data(), static_cast<uLong>(deflated.size()));
    if (status != Z_OK || length != size)
        throw std::invalid_argument(fmt::format("packed bytes are damaged or not {} long", size));
    bytes.resize(size);
    return bytes;
}

}  // namespace crossgrain::store
