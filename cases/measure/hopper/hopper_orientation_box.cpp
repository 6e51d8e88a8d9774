#include "cases/measure/hopper/hopper_orientation_box.hpp"

#include "cases/measure/hopper/hopper_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace crossgrain::measure {
namespace {

constexpr std::uint8_t vertical = 2;

/// Fractions of the orientations at both ends of the pairs, and of pairs alike in one.
struct Fractions {
    std::array<double, 3> here{}, there{}, both{};
};

Fractions fractions(const OrientationPairs& pairs) {
    Fractions f;
    const double n = static_cast<double>(pairs.total());
    for (std::size_t s = 0; s < 3; ++s) {
        for (std::size_t other = 0; other < 3; ++other) {
            const double share = static_cast<double>(pairs.count[s][other]) / n;
            f.here[s] += share;
            f.there[other] += share;
        }
        f.both[s] = static_cast<double>(pairs.count[s][s]) / n;
    }
    return f;
}

/// sum of covariances over sum of geometric means of variances.
std::optional<double> coefficient(const OrientationPairs& pairs,
                                  std::initializer_list<std::size_t> orientations) {
    if (pairs.total() == 0) return std::nullopt;
    const Fractions f = fractions(pairs);
    double covariance = 0, variance = 0;
    for (const std::size_t o : orientations) {
        covariance += f.both[o] - f.here[o] * f.there[o];
        variance += std::sqrt(f.here[o] * (1 - f.here[o]) * f.there[o] * (1 - f.there[o]));
    }
    if (!(variance > 0)) return std::nullopt;
    return covariance / variance;
}

}  // namespace

std::uint64_t OrientationPairs::total() const noexcept {
    std::uint64_t sum = 0;
    for (const auto& row : count) {
        for (const std::uint64_t pairs : row)
            sum += pairs;
    }
    return sum;
}

std::optional<double> OrientationPairs::correlation() const {
    if (total() == 0) return std::nullopt;
    const Fractions f = fractions(*this);
    double alike = 0, by_chance = 0;
    for (std::size_t o = 0; o < 3; ++o) {
        alike += f.both[o];
        by_chance += f.here[o] * f.there[o];
    }
    if (!(by_chance < 1)) return std::nullopt;
    return (alike - by_chance) / (1 - by_chance);
}

std::optional<double> OrientationPairs::correlation_of(std::uint8_t o) const {
    return coefficient(*this, {o - std::size_t{1}});
}

std::optional<double> OrientationPairs::correlation_of_slanted() const {
    return coefficient(*this, {0, 2});
}

OrientationBox::OrientationBox(const scene::HopperFrame& frame, const BoxBounds& bounds) {
    const int reach = static_cast<int>(std::floor(bounds.half_width / column_spacing));
    const int lowest = static_cast<int>(std::ceil(bounds.from / level_spacing));
    const int highest = std::min(static_cast<int>(std::floor(bounds.to / level_spacing)),
                                 static_cast<int>(frame.levels.size()) - 1);
    columns_ = 2 * reach + 1;
    levels_ = std::max(0, highest - lowest + 1);
    state_.reserve(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(levels_));
    for (int k = lowest; k <= highest; ++k) {
        for (int c = -reach; c <= reach; ++c) {
            const std::size_t site = site_at(frame.levels, k, c);
            state_.push_back(site == no_site ? std::uint8_t{0} : frame.state[site]);
        }
    }
}

std::optional<double> OrientationBox::vertical_fraction() const {
    const auto empty = std::ranges::count(state_, std::uint8_t{0});
    const auto grains = static_cast<std::ptrdiff_t>(state_.size()) - empty;
    if (grains == 0) return std::nullopt;
    return static_cast<double>(std::ranges::count(state_, vertical)) / static_cast<double>(grains);
}

OrientationPairs OrientationBox::pairs(const OrientationBox& other, int columns, int levels) const {
    OrientationPairs result;
    const int bottom = std::max(0, -levels), top = std::min(levels_, levels_ - levels);
    const int left = std::max(0, -columns), right = std::min(columns_, columns_ - columns);
    for (int k = bottom; k < top; ++k) {
        for (int c = left; c < right; ++c)
            result.add(at(c, k), other.at(c + columns, k + levels));
    }
    return result;
}

namespace {

struct Decay {
    std::vector<double> g;  ///< at separations 0, 1, 2, ... steps
    double length = 0;      ///< in steps
    bool bounded = false;
};

/// G up to `largest` steps and where it first falls to 1/e.
Decay decay(const std::function<std::optional<double>(int)>& correlation, int largest) {
    constexpr double level = 1 / std::numbers::e;
    Decay result{.g = {1.0}};
    bool found = false;
    for (int i = 1; i <= largest; ++i) {
        const auto g = correlation(i);
        if (!g) break;
        if (!found && *g <= level) {
            found = true;
            result.length = i - 1 + (result.g.back() - level) / (result.g.back() - *g);
        }
        result.g.push_back(*g);
    }
    if (!found) {
        result.bounded = true;
        result.length = static_cast<double>(result.g.size() - 1);
    }
    return result;
}

std::optional<CorrelationPeak>
peak_of(const std::function<std::optional<double>(int)>& correlation) {
    constexpr int end = SpaceTimeCounts::largest_shift;
    std::array<double, 2 * end + 1> g{};
    for (int shift = -end; shift <= end; ++shift) {
        const auto value = correlation(shift);
        if (!value) return std::nullopt;
        g[static_cast<std::size_t>(shift + end)] = *value;
    }
    const auto highest = static_cast<std::size_t>(std::ranges::max_element(g) - g.begin());
    if (highest == 0 || highest + 1 == g.size()) return std::nullopt;
    const double below = g[highest - 1], top = g[highest], above = g[highest + 1];
    const double curvature = below - 2 * top + above;
    const double offset = curvature < 0 ? (below - above) / (2 * curvature) : 0.0;
    return CorrelationPeak{.shift = static_cast<double>(highest) - end + offset, .height = top};
}

}  // namespace

std::optional<PatternShape> pattern_shape(const OrientationBox& box) {
    // Nearest neighbours: vertical (two half-levels) and along both slanted bonds.
    double neighbour = 0;
    constexpr std::array<std::array<int, 2>, 3> bonds{{{0, 2}, {1, 1}, {-1, 1}}};
    for (const auto& [columns, levels] : bonds) {
        const auto g = box.pairs(box, columns, levels).correlation();
        if (!g) return std::nullopt;
        neighbour += *g / 3;
    }
    // Three quarters of the box: beyond, few pairs are left.
    const Decay x =
        decay([&](int i) { return box.pairs(box, 2 * i, 0).correlation(); }, box.columns() * 3 / 8);
    const Decay y =
        decay([&](int i) { return box.pairs(box, 0, 2 * i).correlation(); }, box.levels() * 3 / 8);
    return PatternShape{.neighbour = neighbour,
                        .along_x = x.g,
                        .along_y = y.g,
                        .length_x = x.length * 2 * column_spacing,
                        .length_y = y.length * 2 * level_spacing,
                        .bounded_x = x.bounded,
                        .bounded_y = y.bounded};
}

void SpaceTimeCounts::add(const OrientationBox& earlier, const OrientationBox& later) {
    for (int shift = -largest_shift; shift <= largest_shift; ++shift) {
        const OrientationPairs more = earlier.pairs(later, 0, 2 * shift);
        auto& count = pairs_[static_cast<std::size_t>(shift + largest_shift)].count;
        for (std::size_t s = 0; s < 3; ++s) {
            for (std::size_t other = 0; other < 3; ++other)
                count[s][other] += more.count[s][other];
        }
    }
}

PatternShift pattern_shift(const SpaceTimeCounts& counts) {
    return {
        .all = peak_of([&](int shift) { return counts.at(shift).correlation(); }),
        .vertical = peak_of([&](int shift) { return counts.at(shift).correlation_of(vertical); }),
        .slanted = peak_of([&](int shift) { return counts.at(shift).correlation_of_slanted(); })};
}

}  // namespace crossgrain::measure
