#include "cases/measure/pipe/pipe_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace crossgrain::measure {

PipePicture::PipePicture(const scene::Scene& scene, PipePictureOptions options)
    : recorder_(scene, options.record), rows_(static_cast<std::size_t>(options.rows)) {
    if (options.rows < 2 || options.rows > 2000) {
        throw std::invalid_argument(fmt::format("rows must be 2 to 2000, not {}", options.rows));
    }
}

void PipePicture::finish(Results& results) {
    const PipeRecord& record = recorder_.record();
    if (record.frames() == 0) return;
    const std::size_t stride = (record.frames() + rows_ - 1) / rows_;
    const std::size_t shown = (record.frames() + stride - 1) / stride;
    std::vector<int> density;
    for (std::size_t row = shown; row-- > 0;) {
        for (const std::uint16_t n : record.count_at(row * stride))
            density.push_back(n);
    }
    const auto [least, greatest] = std::ranges::minmax(density);
    Picture picture{
        .name = "space-time",
        .title = fmt::format("density along the pipe (bins of {:.3g} l, gravity to the right) "
                             "against time (t = {:.4g} to {:.4g}, upwards); white {}, black {} "
                             "grains per bin",
                             record.bin, record.times.front(), record.times[(shown - 1) * stride],
                             least, greatest),
        .width = record.bins,
        .height = shown};
    for (int shade = 0; shade < 256; ++shade) {
        const auto grey = static_cast<std::uint8_t>(255 - shade);
        picture.palette.push_back({grey, grey, grey});
    }
    const double range = std::max(1, greatest - least);
    for (const int n : density)
        picture.pixels.push_back(static_cast<std::uint8_t>(std::lround(255 * (n - least) / range)));
    results.pictures.push_back(std::move(picture));
}

}  // namespace crossgrain::measure
