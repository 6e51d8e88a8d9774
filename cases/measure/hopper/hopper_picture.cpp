#include "cases/measure/hopper/hopper_picture.hpp"

#include "cases/measure/hopper/hopper_lattice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace crossgrain::measure {
namespace {

enum Colour : std::uint8_t { emptied = 0, first, vertical, third, outside, surface };

// Three hues that stay apart for all kinds of colour vision (Wong, Nature Methods 8, 441 (2011)).
const std::vector<std::array<std::uint8_t, 3>> palette{
    {255, 255, 255}, {0, 114, 178}, {240, 228, 66}, {213, 94, 0}, {222, 222, 222}, {0, 0, 0}};

/// Highest half-level with a grain, by column; -1 for none.
class Surface {
  public:
    Surface(const scene::HopperFrame& frame, std::int64_t reach)
        : reach_(reach), highest_(static_cast<std::size_t>(2 * reach + 1), -1) {
        for (std::size_t k = 0; k < frame.levels.size(); ++k) {
            const scene::HopperLevel& level = frame.levels[k];
            for (std::size_t i = 0; i < level.sites(); ++i) {
                if (frame.state[level.offset + i] == 0) continue;
                const std::int64_t column = level.first + 2 * static_cast<std::int64_t>(i);
                highest_[static_cast<std::size_t>(column + reach_)] = static_cast<std::int64_t>(k);
            }
        }
    }
    [[nodiscard]] bool is_at(std::int64_t column, std::int64_t level) const {
        return highest_[static_cast<std::size_t>(column + reach_)] == level;
    }

  private:
    std::int64_t reach_;
    std::vector<std::int64_t> highest_;
};

struct Site {
    std::int64_t column = 0, level = 0;
    std::size_t index = no_site;
};

/// The site whose cell holds the point: the nearest of those on the three nearest half-levels.
Site nearest_site(const scene::HopperFrame& frame, double x, double y) {
    Site nearest;
    double least = std::numeric_limits<double>::infinity();
    const auto middle = static_cast<std::int64_t>(std::lround(y / level_spacing));
    const auto levels = static_cast<std::int64_t>(frame.levels.size());
    for (std::int64_t k = std::max<std::int64_t>(0, middle - 1);
         k <= std::min(middle + 1, levels - 1); ++k) {
        // Columns of one half-level are two apart.
        const std::int64_t origin = frame.levels[static_cast<std::size_t>(k)].first;
        const double along = (x / column_spacing - static_cast<double>(origin)) / 2;
        const std::int64_t c = origin + 2 * std::lround(along);
        const double dx = static_cast<double>(c) * column_spacing - x;
        const double dy = static_cast<double>(k) * level_spacing - y;
        if (dx * dx + dy * dy >= least) continue;
        least = dx * dx + dy * dy;
        nearest = {.column = c, .level = k, .index = site_at(frame.levels, k, c)};
    }
    return nearest;
}

std::int64_t widest_column(const scene::HopperFrame& frame) {
    std::int64_t reach = 0;
    for (const scene::HopperLevel& level : frame.levels)
        reach = std::max<std::int64_t>(reach, level.last);
    return reach;
}

Picture draw(const scene::HopperFrame& frame, std::size_t largest) {
    const std::int64_t reach = widest_column(frame);
    const double width = (2 * static_cast<double>(reach) + 1) * column_spacing;
    const double height = (static_cast<double>(frame.levels.size()) + 1) * level_spacing;
    const double scale = static_cast<double>(largest) / std::max(width, height);
    const auto pixels = [&](double length) {
        return std::clamp<std::size_t>(static_cast<std::size_t>(std::lround(length * scale)), 1,
                                       largest);
    };
    Picture picture{.width = pixels(width), .height = pixels(height), .palette = palette};
    picture.pixels.reserve(picture.width * picture.height);
    const Surface free_surface(frame, reach);
    for (std::size_t row = 0; row < picture.height; ++row) {
        const double y = height - (static_cast<double>(row) + 0.5) / scale - level_spacing;
        for (std::size_t column = 0; column < picture.width; ++column) {
            const double x = (static_cast<double>(column) + 0.5) / scale - width / 2;
            const Site site = nearest_site(frame, x, y);
            std::uint8_t colour = outside;
            if (site.index != no_site) {
                colour = free_surface.is_at(site.column, site.level) ? std::uint8_t{surface}
                                                                     : frame.state[site.index];
            }
            picture.pixels.push_back(colour);
        }
    }
    return picture;
}

}  // namespace

HopperPicture::HopperPicture(const scene::HopperAutomaton& scene, HopperPictureOptions options)
    : scene_(scene), options_(std::move(options)) {
    if (options_.at.empty()) options_.at.push_back(scene.iterations);
    for (const std::int64_t at : options_.at) {
        if (at == scene.iterations || (at >= 0 && at < scene.iterations && at % scene.every == 0)) {
            continue;
        }
        throw std::invalid_argument(
            fmt::format("iteration {} is no frame: these come every {} up to {}", at, scene.every,
                        scene.iterations));
    }
    check_ranges(options_);
}

void HopperPicture::add(const scene::HopperFrame& frame) {
    if (frame.angle_index != 0 || frame.replica != 0) return;
    if (std::ranges::find(options_.at, frame.iteration) == options_.at.end()) return;
    Picture picture = draw(frame, static_cast<std::size_t>(options_.largest));
    picture.name = fmt::format("orientation-{}", frame.iteration);
    picture.title = fmt::format(
        "Orientations after {} iterations, theta = {:.4g} degrees, C_D = {:g}, C_O = {:g}: blue "
        "1, yellow 2 (vertical), red 3, black the free surface",
        frame.iteration, frame.angle, scene_.c_d, scene_.c_o);
    pictures_.push_back(std::move(picture));
}

void HopperPicture::finish(Results& results) {
    for (Picture& picture : pictures_)
        results.pictures.push_back(std::move(picture));
    pictures_.clear();
}

}  // namespace crossgrain::measure
