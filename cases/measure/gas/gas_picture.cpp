#include "cases/measure/gas/gas_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace crossgrain::measure {

GasPicture::GasPicture(const scene::GasSampling& sampling, GasPictureOptions options)
    : sampling_(sampling), options_(options),
      stride_(std::max<std::int64_t>(1, (sampling.frames() + options.rows - 1) /
                                            std::max<std::int64_t>(1, options.rows))) {
    if (!sampling.fields.count) throw std::invalid_argument("the picture needs the field 'count'");
    if (options.rows < 2 || options.rows > 2000) {
        throw std::invalid_argument(fmt::format("rows must be 2 to 2000, not {}", options.rows));
    }
    if (options.replica < 0 || options.replica >= sampling.replicas) {
        throw std::invalid_argument(
            fmt::format("replica must be 0 to {}, not {}", sampling.replicas - 1, options.replica));
    }
}

void GasPicture::add(const scene::GasFrame& frame) {
    if (frame_++ % stride_ != 0) return;
    if (density_.empty()) first_step_ = frame.step;
    last_step_ = frame.step;
    for (std::size_t i = 0; i < frame.bins; ++i) {
        density_.push_back(
            frame.count[i * frame.replicas + static_cast<std::size_t>(options_.replica)]);
    }
}

void GasPicture::finish(Results& results) {
    if (density_.empty()) return;
    const auto width = static_cast<std::size_t>(sampling_.bins());
    const auto [least, greatest] = std::ranges::minmax(density_);
    Picture picture{.name = "space-time",
                    .title = fmt::format("density along the pipe (bins of {} sites, gravity to the "
                                         "right) against time (steps {} to {}, upwards); white {}, "
                                         "black {} particles per bin",
                                         sampling_.bin, first_step_, last_step_, least, greatest),
                    .width = width,
                    .height = density_.size() / width};
    for (int shade = 0; shade < 256; ++shade) {
        const auto grey = static_cast<std::uint8_t>(255 - shade);
        picture.palette.push_back({grey, grey, grey});
    }
    const double range = std::max(1, greatest - least);
    for (std::size_t row = picture.height; row-- > 0;) {
        for (std::size_t i = 0; i < width; ++i) {
            const double above = density_[row * width + i] - least;
            picture.pixels.push_back(static_cast<std::uint8_t>(std::lround(255 * above / range)));
        }
    }
    results.pictures.push_back(std::move(picture));
}

}  // namespace crossgrain::measure
