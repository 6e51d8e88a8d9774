#include "adapters/dump/dump_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

namespace crossgrain::adapters::dump {

namespace {

/// Smallest interval around the values; (0, 0) when there are none.
std::pair<double, double> extent(std::span<const double> values) {
    if (values.empty()) return {0.0, 0.0};
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return {*low, *high};
}

void append_header(fmt::memory_buffer& text, const scene::Scene& scene, const scene::Frame& frame) {
    auto [x_low, x_high] = extent(frame.x);
    auto [y_low, y_high] = extent(frame.y);
    if (scene.periodic_x) {
        x_low = 0.0;
        x_high = *scene.periodic_x;
    }
    if (scene.periodic_y) {
        y_low = 0.0;
        y_high = *scene.periodic_y;
    }
    if (frame.lid) {
        y_low = std::min(y_low, frame.lid->height);
        y_high = std::max(y_high, frame.lid->height);
    }
    fmt::format_to(std::back_inserter(text),
                   "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\n"
                   "ITEM: BOX BOUNDS {} {} pp\n{:.17g} {:.17g}\n{:.17g} {:.17g}\n-0.5 0.5\n"
                   "ITEM: ATOMS id type xu yu vx vy{}\n",
                   frame.step, frame.x.size() + (frame.lid ? 1 : 0), scene.periodic_x ? "pp" : "ss",
                   scene.periodic_y ? "pp" : "ss", x_low, x_high, y_low, y_high,
                   scene.has_friction() ? " omegaz" : "");
}

}  // namespace

DumpWriter::DumpWriter(const scene::Scene& scene, std::ostream& out) : scene_(scene), out_(out) {}

void DumpWriter::operator()(const scene::Frame& frame) {
    fmt::memory_buffer text;
    append_header(text, scene_, frame);
    const bool spins = scene_.has_friction();
    auto end = std::back_inserter(text);
    for (std::size_t i = 0; i < frame.x.size(); ++i) {
        fmt::format_to(end, "{} 1 {:.17g} {:.17g} {:.17g} {:.17g}", i + 1, frame.x[i], frame.y[i],
                       frame.vx[i], frame.vy[i]);
        if (spins) fmt::format_to(end, " {:.17g}", frame.omega[i]);
        text.push_back('\n');
    }
    if (frame.lid) {
        fmt::format_to(end, "{} 2 0 {:.17g} 0 {:.17g}{}\n", frame.x.size() + 1, frame.lid->height,
                       frame.lid->velocity, spins ? " 0" : "");
    }
    if (!out_.write(text.data(), static_cast<std::streamsize>(text.size()))) {
        throw std::ios_base::failure("cannot write the dump");
    }
}

}  // namespace crossgrain::adapters::dump
