#include "reports/web/png.hpp"

#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <png.h>

#include "adapters/run/store/picture_fault.hpp"

namespace crossgrain::reports {
namespace {

std::vector<png_byte> colour_map(const measure::Picture& picture) {
    std::vector<png_byte> entries;
    entries.reserve(3 * picture.palette.size());
    for (const auto& colour : picture.palette)
        entries.insert(entries.end(), colour.begin(), colour.end());
    return entries;
}

}  // namespace

std::string png_bytes(const measure::Picture& picture) {
    if (const auto fault = store::picture_fault(picture))
        throw std::invalid_argument(fmt::format("picture '{}' {}", picture.name, *fault));
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.width);
    image.height = static_cast<png_uint_32>(picture.height);
    image.format = PNG_FORMAT_RGB_COLORMAP;
    image.colormap_entries = static_cast<png_uint_32>(picture.palette.size());
    const std::vector<png_byte> colours = colour_map(picture);
    const auto write = [&](void* memory, png_alloc_size_t& size) {
        constexpr int as_it_is = 0;  // bytes are sRGB already
        constexpr int packed_rows = 0;
        if (png_image_write_to_memory(&image, memory, &size, as_it_is, picture.pixels.data(),
                                      packed_rows, colours.data()) == 0)
            throw std::runtime_error(
                fmt::format("picture '{}' could not be made: {}", picture.name, image.message));
    };
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::string bytes(size, '\0');
    write(bytes.data(), size);
    bytes.resize(size);
    return bytes;
}

}  // namespace crossgrain::reports
