#include "cases/measure/gas/gas_profile.hpp"

#include "cases/measure/waves/over_samples.hpp"
#include "cases/measure/waves/wave_profile.hpp"
#include "native/base/random.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <numeric>
#include <stdexcept>

namespace crossgrain::measure {
namespace {

constexpr std::uint64_t shuffle_seed = 1995;

bool power_of_two(std::int64_t value) {
    return value >= 2 && std::has_single_bit(static_cast<std::uint64_t>(value));
}

void check(const scene::GasSampling& sampling, const GasProfileOptions& options) {
    const auto require = [](bool holds, const std::string& what) {
        if (!holds) throw std::invalid_argument(what);
    };
    require(sampling.periodic, "the profile needs a periodic pipe");
    require(sampling.fields.count, "the profile needs the field 'count'");
    require(sampling.bins() >= 8, "the profile needs eight bins or more");
    require(power_of_two(options.fields),
            fmt::format("fields must be a power of two, not {}", options.fields));
    require(power_of_two(options.groups),
            fmt::format("groups must be a power of two, not {}", options.groups));
    require(sampling.frames() >= options.fields,
            fmt::format("{} fields need more than the run's {} frames", options.fields,
                        sampling.frames()));
    require(sampling.replicas >= options.groups,
            fmt::format("{} groups need more than {} replicas", options.groups, sampling.replicas));
}

// Fisher & Yates, the same for all replicas, anew at each frame.
std::vector<std::uint16_t> shuffle_bins(const scene::GasFrame& frame, std::int64_t number) {
    std::vector<std::size_t> order(frame.bins);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = frame.bins - 1; i > 0; --i) {
        const auto counter = static_cast<std::uint64_t>(number) * frame.bins + i;
        const double u = uniform(shuffle_seed, RandomStream::jitter, counter);
        std::swap(order[i], order[static_cast<std::size_t>(u * static_cast<double>(i + 1))]);
    }
    std::vector<std::uint16_t> shuffled;
    for (const std::size_t bin : order) {
        const auto row = frame.count.subspan(bin * frame.replicas, frame.replicas);
        shuffled.insert(shuffled.end(), row.begin(), row.end());
    }
    return shuffled;
}

// Members 0, 2, 4, ... (parity 0) or 1, 3, 5, ... of an ensemble of fields.
std::vector<float> every_second(FieldShape shape, const std::vector<float>& fields,
                                std::size_t parity) {
    std::vector<float> half;
    for (std::size_t x = 0; x < shape.bins; ++x) {
        for (std::size_t r = parity; r < shape.samples; r += 2)
            half.push_back(fields[x * shape.samples + r]);
    }
    return half;
}

// Merges neighbours until `count` members are left.
std::vector<float> merge_down(std::size_t bins, std::vector<float> fields, std::size_t count) {
    for (std::size_t members = fields.size() / bins; members > count; members /= 2) {
        const FieldShape whole{bins, members}, half{bins, members / 2};
        fields =
            merge_overlapping(half, every_second(whole, fields, 0), every_second(whole, fields, 1));
    }
    return fields;
}

}  // namespace

GasProfile::GasProfile(const scene::GasSampling& sampling, GasProfileOptions options)
    : sampling_(sampling), options_(options), shape_{static_cast<std::size_t>(sampling.bins()),
                                                     static_cast<std::size_t>(sampling.replicas)} {
    check(sampling, options);
}

void GasProfile::Ladder::add(FieldShape shape, std::vector<float> field) {
    std::size_t level = 0;
    while (level < waiting.size() && waiting[level]) {
        field = merge_overlapping(shape, *waiting[level], field);
        waiting[level++].reset();
    }
    if (level == waiting.size()) waiting.emplace_back();
    waiting[level] = std::move(field);
}

void GasProfile::add(const scene::GasFrame& frame) {
    if (frame_ == 0) {
        const double all = std::accumulate(frame.count.begin(), frame.count.end(), 0.0);
        mean_ = all / static_cast<double>(shape_.size());
    }
    if (frame_ < options_.fields) {
        const std::vector<std::uint16_t> shuffled = shuffle_bins(frame, frame_);
        fields_.add(shape_, fluctuation(shape_, frame.count, 1));
        shuffled_.add(shape_, fluctuation(shape_, std::span<const std::uint16_t>(shuffled), 1));
    }
    ++frame_;
}

// One profile per group, each of as many replicas: a power of two.
std::vector<float> GasProfile::groups_of(std::vector<float> profiles) const {
    const auto groups = static_cast<std::size_t>(options_.groups);
    const std::size_t used = std::bit_floor(shape_.samples / groups) * groups;
    std::vector<float> kept;
    for (std::size_t x = 0; x < shape_.bins; ++x) {
        const auto* row = &profiles[x * shape_.samples];
        kept.insert(kept.end(), row, row + used);
    }
    return merge_down(shape_.bins, std::move(kept), groups);
}

// Profiles of the groups over the mean, shape (groups)(bins), moved onto the merger of all of them,
// whose peak comes to bin bins/2.
std::vector<std::vector<double>> GasProfile::aligned(const Ladder& ladder) const {
    const std::vector<float> groups = groups_of(*ladder.waiting.back());
    const std::vector<float> whole = merge_down(shape_.bins, groups, 1);
    const std::size_t bins = shape_.bins, count = groups.size() / bins;
    const auto peak = static_cast<std::size_t>(std::ranges::max_element(whole) - whole.begin());
    const FieldShape one{bins, 1};
    std::vector<std::vector<double>> result;
    for (std::size_t g = 0; g < count; ++g) {
        std::vector<float> profile, overlap(bins, 0.0F);
        for (std::size_t x = 0; x < bins; ++x)
            profile.push_back(groups[x * count + g]);
        add_overlap(one, whole, profile, overlap);
        const std::size_t shift = best_shift(one, overlap, 0).bins;
        std::vector<double> moved;
        for (std::size_t x = 0; x < bins; ++x)
            moved.push_back(double{profile[(x + peak + shift + bins - bins / 2) % bins]} / mean_);
        result.push_back(std::move(moved));
    }
    return result;
}

void GasProfile::finish(Results& results) {
    if (frame_ < options_.fields || mean_ <= 0) return;
    const AlignedProfiles profiles{aligned(fields_), aligned(shuffled_)};
    const double sites = static_cast<double>(sampling_.bin) * sampling_.width;
    results.series.push_back(profile_series(profiles, {.bin = static_cast<double>(sampling_.bin),
                                                       .density = mean_ / sites,
                                                       .length_unit = "sites",
                                                       .density_unit = "1/site"}));
    const std::vector<WaveShape> shapes = append_profile(profiles, results);
    if (shapes.size() < profiles.waves.size()) return;
    std::vector<double> widths, scaled;
    for (const WaveShape& shape : shapes) {
        widths.push_back(shape.width * sampling_.bin);
        scaled.push_back(widths.back() / sampling_.length);
    }
    results.measurements.push_back(over_samples("profile_width", widths, "sites"));
    results.measurements.push_back(over_samples("profile_width_over_length", scaled, "1"));
}

}  // namespace crossgrain::measure
