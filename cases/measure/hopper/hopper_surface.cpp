#include "cases/measure/hopper/hopper_surface.hpp"

#include "cases/measure/hopper/hopper_lattice.hpp"
#include "cases/measure/hopper/hopper_replicas.hpp"
#include "native/numerics/line_fit.hpp"
#include "native/numerics/mean_with_error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>

namespace crossgrain::measure {
namespace {

constexpr double bare = -1;            // a column without grains
constexpr double lattice_slope = 30;   // degrees, between two neighbours that are not vertical
constexpr double least_depth = 2;      // spacings below the initial surface
constexpr std::size_t steep_span = 8;  // columns: seven spacings

/// y of the highest grain of each column from `first` on.
std::vector<double> profile(const scene::HopperFrame& frame, std::int32_t first,
                            std::int32_t last) {
    std::vector<double> h(static_cast<std::size_t>(last - first) + 1, bare);
    for (std::size_t k = 0; k < frame.levels.size(); ++k) {
        const scene::HopperLevel& level = frame.levels[k];
        for (std::size_t i = 0; i < level.sites(); ++i) {
            if (frame.state[level.offset + i] == 0) continue;
            const auto column = static_cast<std::size_t>(level.first - first) + 2 * i;
            h[column] = static_cast<double>(k) * level_spacing;
        }
    }
    return h;
}

struct Crater {
    std::size_t first = 0, last = 0;  ///< columns
    std::size_t lowest = 0;
    double depth = 0;
};

/// The columns around the lowest one that lie below the initial surface.
std::optional<Crater> crater_of(std::span<const double> h, double top) {
    const auto lowest = static_cast<std::size_t>(std::ranges::min_element(h) - h.begin());
    if (top - h[lowest] <= least_depth) return std::nullopt;
    Crater crater{.first = lowest, .last = lowest, .lowest = lowest};
    const auto lowered = [&](std::size_t c) { return top - h[c] > least_depth; };
    while (crater.first > 0 && lowered(crater.first - 1))
        --crater.first;
    while (crater.last + 1 < h.size() && lowered(crater.last + 1))
        ++crater.last;
    crater.depth = top - std::max(h[lowest], 0.0);
    return crater;
}

/// |dh/dx| by least squares over columns first..last; nothing for fewer than `steep_span`.
std::optional<double> slope(std::span<const double> h, std::size_t first, std::size_t last) {
    if (last < first + steep_span - 1) return std::nullopt;
    std::vector<double> x;
    for (std::size_t c = first; c <= last; ++c)
        x.push_back(static_cast<double>(c) * column_spacing);
    return std::abs(numerics::line_through(x, h.subspan(first, last - first + 1)).slope);
}

double degrees(double tangent) {
    return std::atan(tangent) * 180 / std::numbers::pi;
}

std::optional<double> mean_slope(std::span<const double> h, const Crater& crater) {
    const auto left = slope(h, crater.first, crater.lowest);
    const auto right = slope(h, crater.lowest, crater.last);
    if (!left || !right) return std::nullopt;
    return degrees((*left + *right) / 2);
}

std::optional<double> steepest_slope(std::span<const double> h, const Crater& crater) {
    std::optional<double> steepest;
    for (std::size_t c = crater.first; c + steep_span - 1 <= crater.last; ++c) {
        const double here = *slope(h, c, c + steep_span - 1);
        if (!steepest || here > *steepest) steepest = here;
    }
    if (!steepest) return std::nullopt;
    return degrees(*steepest);
}

}  // namespace

HopperSurface::HopperSurface(const scene::HopperAutomaton& scene)
    : replicas_(scene.replicas), top_((scene.levels - 1) * level_spacing) {
    if (scene.angles.size() != 1) throw std::invalid_argument("the scene has more than one angle");
}

void HopperSurface::add(const scene::HopperFrame& frame) {
    if (!frame.last) return;
    std::int32_t first = 0, last = 0;
    for (const scene::HopperLevel& level : frame.levels) {
        first = std::min(first, level.first);
        last = std::max(last, level.last);
    }
    first_column_ = first;
    profiles_.push_back(profile(frame, first, last));
}

void HopperSurface::append_series(Results& results) const {
    Series series{.name = "surface",
                  .columns = {"x", "h", "standard_error"},
                  .values = std::vector<std::vector<double>>(3),
                  .units = {"spacings", "spacings", "spacings"}};
    for (std::size_t c = 0; c < profiles_.front().size(); ++c) {
        std::vector<double> h;
        for (const auto& one : profiles_)
            h.push_back(std::max(one[c], 0.0));
        const numerics::MeanWithError mean = numerics::mean_with_error(h);
        series.values[0].push_back((first_column_ + static_cast<double>(c)) * column_spacing);
        series.values[1].push_back(mean.value);
        series.values[2].push_back(mean.standard_error);
    }
    results.series.push_back(std::move(series));
}

void HopperSurface::append_scatter(Results& results, std::span<const double> depths) const {
    const double depth = numerics::mean_with_error(depths).value;
    // Half of the replicas against the other half would waste data: pairs of successive replicas
    // are independent samples of a squared difference, twice the variance.
    std::vector<double> scatter;
    for (std::size_t r = 0; r + 1 < profiles_.size(); r += 2) {
        double squares = 0, columns = 0;
        for (std::size_t c = 0; c < profiles_[r].size(); ++c) {
            const double a = std::max(profiles_[r][c], 0.0);
            const double b = std::max(profiles_[r + 1][c], 0.0);
            if (top_ - std::min(a, b) <= least_depth) continue;
            squares += (a - b) * (a - b) / 2;
            ++columns;
        }
        if (columns > 0) scatter.push_back(std::sqrt(squares / columns) / depth);
    }
    append_replica_mean(results, "surface_scatter", scatter);
}

void HopperSurface::finish(Results& results) {
    if (profiles_.empty() || profiles_.size() < static_cast<std::size_t>(replicas_)) return;
    std::vector<double> depths, widths, slopes, steepest;
    for (const auto& h : profiles_) {
        const auto crater = crater_of(h, top_);
        if (!crater) continue;
        depths.push_back(crater->depth);
        widths.push_back(static_cast<double>(crater->last - crater->first + 1) * column_spacing /
                         2);
        if (const auto mean = mean_slope(h, *crater)) slopes.push_back(*mean);
        if (const auto most = steepest_slope(h, *crater)) steepest.push_back(*most);
    }
    const auto append = [&](const char* name, std::span<const double> samples, const char* unit) {
        if (samples.size() == profiles_.size()) append_replica_mean(results, name, samples, unit);
    };
    append("crater_depth", depths, "spacings");
    append("crater_half_width", widths, "spacings");
    append("surface_slope", slopes, "degrees");
    append("surface_slope_steepest", steepest, "degrees");
    const auto steep = std::ranges::count_if(slopes, [](double s) { return s > lattice_slope; });
    append_share(results, "steep_share", static_cast<std::size_t>(steep), slopes.size());
    if (depths.size() == profiles_.size()) append_scatter(results, depths);
    append_series(results);
}

}  // namespace crossgrain::measure
