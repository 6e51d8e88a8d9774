#include "cases/measure/pipe/pipe_record.hpp"

#include "native/base/memory_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace crossgrain::measure {

double PipeRecord::mean_speed(std::size_t first, std::size_t last) const {
    double grains = 0, summed = 0;
    for (std::size_t i = first * bins; i < last * bins; ++i) {
        grains += count[i];
        summed += static_cast<double>(flux[i]);
    }
    return grains > 0 ? summed / grains : 0.0;
}

BinnedRecord PipeRecord::in_blocks(std::size_t samples) const {
    return {.shape = {bins, samples}, .length = length, .interval = interval};
}

std::vector<std::uint16_t> PipeRecord::field(std::size_t samples, std::size_t t) const {
    const std::size_t block = frames() / samples;
    std::vector<std::uint16_t> counts(bins * samples);
    for (std::size_t s = 0; s < samples; ++s) {
        const auto here = count_at(s * block + t);
        for (std::size_t i = 0; i < bins; ++i)
            counts[i * samples + s] = here[i];
    }
    return counts;
}

PipeRecorder::PipeRecorder(const scene::Scene& scene, PipeRecordOptions options)
    : section_(pipe_section(scene)), skip_(options.skip) {
    if (!(options.bin > 0)) {
        throw std::invalid_argument(fmt::format("bin must be > 0 diameters, not {}", options.bin));
    }
    const double bins = std::round(section_.length / (options.bin * section_.diameter));
    if (bins < 16) {
        throw std::invalid_argument(fmt::format(
            "bins of {} diameters give {} in the pipe, 16 or more are needed", options.bin, bins));
    }
    // Grown by doubling.
    const auto frames = static_cast<double>(scene.steps / scene.frame_every + 1);
    require_memory(2 * frames * bins * (sizeof(record_.count[0]) + sizeof(record_.flux[0])),
                   "counts in all bins and frames");
    record_.bins = static_cast<std::size_t>(bins);
    record_.length = section_.length;
    record_.bin = section_.length / bins;
    record_.interval = section_.interval;
    record_.diameter = section_.diameter;
}

void PipeRecorder::add(const scene::Frame& frame) {
    if (frame.time < skip_) return;
    const std::size_t bins = record_.bins, from = record_.count.size();
    record_.times.push_back(frame.time);
    record_.count.resize(from + bins, 0);
    record_.flux.resize(from + bins, 0.0F);
    for (const std::size_t i : section_.mobile) {
        const double x = section_.down(frame.y[i]) / record_.bin;
        const std::size_t at = from + std::min(bins - 1, static_cast<std::size_t>(x));
        ++record_.count[at];
        record_.flux[at] -= static_cast<float>(frame.vy[i]);
    }
}

std::vector<FrameBlock> equal_blocks(std::size_t frames, std::size_t blocks) {
    std::vector<FrameBlock> result;
    const std::size_t length = frames / blocks;
    for (std::size_t b = 0; b < blocks; ++b)
        result.push_back({b * length, b + 1 == blocks ? frames : (b + 1) * length});
    return result;
}

std::optional<Finding> too_coarse_sampling(const PipeRecord& record) {
    const double fallen = std::abs(record.mean_speed()) * record.interval;
    if (fallen < record.bin) return std::nullopt;
    return Finding{.name = "sampling",
                   .label = "too coarse",
                   .detail = fmt::format("grains fall {:.3g} in the {:.3g} between two frames, a "
                                         "bin is {:.3g}: spectra in time would be aliased and are "
                                         "not taken; wanted are frames every {:.2g} or less",
                                         fallen, record.interval, record.bin,
                                         record.bin / fallen * record.interval / 2)};
}

}  // namespace crossgrain::measure
