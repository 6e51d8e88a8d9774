// Compressed text files, whole.
#pragma once

#include "adapters/dump/zstd_file.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>

namespace crossgrain::tests {

inline std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Bytes that are fed in pieces of `piece`.
inline std::string unpacked(std::string_view bytes, std::size_t piece = std::string_view::npos) {
    std::string text;
    adapters::dump::ZstdUnpacker unpacker([&](std::string_view more) { text += more; });
    for (; !bytes.empty(); bytes.remove_prefix(std::min(piece, bytes.size())))
        unpacker.feed(bytes.substr(0, piece));
    unpacker.finish();
    return text;
}

inline std::string unpacked_file(const std::filesystem::path& file) {
    return unpacked(bytes_of(file));
}

inline void pack_into(const std::filesystem::path& file, std::string_view text) {
    adapters::dump::ZstdFile out(file);
    out << text;
    if (!out.finish()) throw std::runtime_error("cannot write " + file.string());
}

}  // namespace crossgrain::tests
