#include "cases/measure/pipe/pipe_structure.hpp"

#include "cases/measure/pipe/pipe_modes.hpp"
#include "cases/measure/statistics/blocking.hpp"

#include <complex>
#include <stdexcept>
#include <vector>

namespace crossgrain::measure {

PipeStructure::PipeStructure(const scene::Scene& scene, PipeStructureOptions options)
    : recorder_(scene, {.skip = options.skip, .bin = 1}), options_(options),
      factor_(recorder_.record().in_blocks(pipe_blocks).shape, {options.k_min, options.k_max}) {
    if (options.k_max > 64) throw std::invalid_argument("needs k_max <= 64");
}

void PipeStructure::finish(Results& results) {
    const PipeRecord& record = recorder_.record();
    if (record.frames() < fewest_pipe_frames) return;
    for (std::size_t t = 0; t < record.frames() / pipe_blocks; ++t)
        factor_.add(record.field(pipe_blocks, t));
    factor_.append(results);
    const auto first = static_cast<std::size_t>(options_.k_min);
    const PipeMode mode = pipe_mode(record, first);
    std::vector<double> series;
    for (const auto& density : mode.density)
        series.push_back(std::norm(density) /
                         static_cast<double>(recorder_.section().mobile.size()));
    if (const auto mean = blocked_mean(series)) {
        results.measurements.push_back({.observable = "structure_factor",
                                        .value = mean->value,
                                        .standard_error = mean->standard_error,
                                        .n = mean->blocks,
                                        .settings = {{"k", static_cast<double>(first)}}});
    }
}

}  // namespace crossgrain::measure
