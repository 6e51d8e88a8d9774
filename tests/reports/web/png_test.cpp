// Pictures read back with libpng are what they were, colour by colour; broken ones are refused.
#include <boost/test/unit_test.hpp>
#include <png.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "reports/web/png.hpp"

using namespace crossgrain;

namespace {

struct Decoded {
    std::size_t width = 0, height = 0;
    std::vector<png_byte> rgb;  ///< shape (height, width, 3)
};

Decoded decoded(const std::string& bytes) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    BOOST_TEST_REQUIRE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()));
    image.format = PNG_FORMAT_RGB;
    Decoded result{.width = image.width, .height = image.height, .rgb = {}};
    result.rgb.resize(PNG_IMAGE_SIZE(image));
    BOOST_TEST_REQUIRE(png_image_finish_read(&image, nullptr, result.rgb.data(), 0, nullptr));
    return result;
}

/// Every colour of a palette with as many different entries, in a picture of an odd width.
measure::Picture picture_of(std::size_t colours) {
    measure::Picture picture{.name = "p", .width = 7, .height = 41};
    for (std::size_t i = 0; i < colours; ++i) {
        picture.palette.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(37 * i),
                                   static_cast<std::uint8_t>(255 - i)});
    }
    for (std::size_t i = 0; i < picture.width * picture.height; ++i)
        picture.pixels.push_back(static_cast<std::uint8_t>(i % colours));
    return picture;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_pixel_has_the_colour_of_its_palette_entry) {
    for (const std::size_t colours : {1, 2, 3, 4, 5, 16, 17, 255, 256}) {
        const auto picture = picture_of(colours);
        const Decoded back = decoded(reports::png_bytes(picture));
        BOOST_TEST(back.width == picture.width);
        BOOST_TEST(back.height == picture.height);
        std::vector<png_byte> wanted;
        for (const auto pixel : picture.pixels) {
            const auto& colour = picture.palette[pixel];
            wanted.insert(wanted.end(), colour.begin(), colour.end());
        }
        BOOST_TEST((back.rgb == wanted), colours << " colours");
    }
}

BOOST_AUTO_TEST_CASE(it_is_a_palette_image) {
    const std::string bytes = reports::png_bytes(picture_of(256));
    BOOST_TEST(bytes.substr(12, 4) == "IHDR");
    constexpr char palette = 3;  // colour type, byte 9 of IHDR
    BOOST_TEST(bytes[16 + 9] == palette);
}

BOOST_AUTO_TEST_CASE(pictures_whose_parts_do_not_fit_are_refused) {
    const auto refused = [](auto spoil) {
        auto picture = picture_of(5);
        spoil(picture);
        BOOST_CHECK_THROW((void)reports::png_bytes(picture), std::invalid_argument);
    };
    refused([](measure::Picture& p) { p.width = 8; });
    refused([](measure::Picture& p) { p.height = 0; });
    refused([](measure::Picture& p) { p = {}; });
    refused([](measure::Picture& p) { p.palette.pop_back(); });
    refused([](measure::Picture& p) { p.palette.resize(257); });
}
