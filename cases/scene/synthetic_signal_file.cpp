#include "cases/scene/gas_sampling_file.hpp"
#include "cases/scene/model_file.hpp"

#include <fmt/format.h>

#include <limits>

namespace crossgrain::scene {
namespace {

using toml_input::Range;
using toml_input::TomlTable;

/// Counts are whole, not negative and fit 16 bits: six standard deviations of the noise must.
void check_counts(const TomlTable& t, const SyntheticSignal& signal) {
    const double swing = 6 * signal.noise + signal.wave_amplitude;
    constexpr double most = std::numeric_limits<std::uint16_t>::max();
    if (signal.mean - swing >= 0 && signal.mean + swing <= most) return;
    throw t.error("mean", "does not keep the counts in range", fmt::format("{:g}", signal.mean),
                  fmt::format("a number from {:g} to {:g}: six times the noise and the wave away "
                              "from 0 and from {:g}",
                              swing, most - swing, most));
}

}  // namespace

SyntheticSignal read_synthetic_signal(const TomlTable& t, const SceneSelection& selection) {
    SyntheticSignal signal;
    signal.name = selection.name;
    signal.seed = selection.seed;
    signal.sampling = read_gas_sampling(t);
    const GasFields& fields = signal.sampling.fields;
    if (!fields.count || fields.rests || fields.momentum) {
        throw t.error("sample", "asks for fields a signal does not have", "",
                      "fields = [\"count\"]");
    }
    signal.mean = t.number("mean", Range::positive());
    signal.noise = t.number("noise", Range::positive());
    signal.exponent = t.number(
        "exponent", {.low = 0, .high = 2, .low_open = false, .text = "a number in [0, 2]"});
    signal.wave_amplitude = t.optional_number("wave_amplitude", Range::not_negative()).value_or(0);
    signal.wave_velocity = t.optional_number("wave_velocity", Range::any()).value_or(0);
    if (t.has("wave_number")) {
        const std::int64_t number = t.integer("wave_number", 1);
        if (2 * number > signal.sampling.bins()) {
            throw t.error(
                "wave_number", "is out of range", fmt::format("{}", number),
                fmt::format("at most half the number of bins, {}", signal.sampling.bins()));
        }
        signal.wave_number = static_cast<int>(number);
    }
    check_counts(t, signal);
    t.reject_unknown_keys();
    return signal;
}

}  // namespace crossgrain::scene
