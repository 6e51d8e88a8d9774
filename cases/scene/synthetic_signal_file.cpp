#include "cases/scene/gas_sampling_file.hpp"
#include "cases/scene/model_file.hpp"

#include <fmt/format.h>

#include <limits>

namespace crossgrain::scene {
namespace {

using toml_input::KeyedTable;
using toml_input::NumberRule;
using toml_input::Range;

/// Counts are whole, not negative and fit 16 bits: six standard deviations of the noise must.
void check_counts(const KeyedTable& t, const SyntheticSignal& signal) {
    const double swing = 6 * signal.noise + signal.wave_amplitude;
    constexpr double most = std::numeric_limits<std::uint16_t>::max();
    if (signal.mean - swing >= 0 && signal.mean + swing <= most) return;
    throw t.error("mean", "does not keep the counts in range", fmt::format("{:g}", signal.mean),
                  fmt::format("a number from {:g} to {:g}: six times the noise and the wave away "
                              "from 0 and from {:g}",
                              swing, most - swing, most));
}

}  // namespace

const toml_input::TableKeys& synthetic_signal_keys() {
    using enum toml_input::Need;
    static const toml_input::TableKeys keys = [] {
        toml_input::TableKeys scene{
            .name = "scene",
            .keys = {
                {"mean", NumberRule{Range::positive()}, "count of a bin", required},
                {"noise", NumberRule{Range::positive()}, "standard deviation of a count", required},
                {"exponent", NumberRule{{.low = 0, .high = 2, .text = "a number in [0, 2]"}},
                 "alpha of 1/f^alpha", required},
                {"wave_amplitude", NumberRule{Range::not_negative()}, "default 0"},
                {"wave_velocity", NumberRule{Range::any()}, "sites per step, default 0"},
                {"wave_number", toml_input::IntegerRule{1},
                 "wave lengths in the pipe, at most half the number of bins"}}};
        for (auto& key : gas_sampling_keys())
            scene.keys.push_back(std::move(key));
        return scene;
    }();
    return keys;
}

SyntheticSignal read_synthetic_signal(const toml_input::TomlTable& table,
                                      const SceneSelection& selection) {
    const KeyedTable t(table, synthetic_signal_keys());
    SyntheticSignal signal;
    signal.name = selection.name;
    signal.seed = selection.seed;
    signal.sampling = read_gas_sampling(t);
    const GasFields& fields = signal.sampling.fields;
    if (!fields.count || fields.rests || fields.momentum) {
        throw t.error("sample", "asks for fields a signal does not have", "",
                      "fields = [\"count\"]");
    }
    signal.mean = t.number("mean");
    signal.noise = t.number("noise");
    signal.exponent = t.number("exponent");
    signal.wave_amplitude = t.optional_number("wave_amplitude").value_or(0);
    signal.wave_velocity = t.optional_number("wave_velocity").value_or(0);
    if (t.has("wave_number")) {
        const std::int64_t number = t.integer("wave_number");
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
