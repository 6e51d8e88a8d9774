#include "cases/scene/gas_sampling_file.hpp"

#include "cases/scene/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace crossgrain::scene {
namespace {

using toml_input::IntegerRule;
using toml_input::KeyedTable;
using toml_input::TableKeys;
using enum toml_input::Need;

constexpr std::int64_t longest = 10'000'000, widest = 8'000;

void check_multiple(const KeyedTable& t, const char* key, std::int64_t value, const char* of,
                    std::int64_t unit) {
    if (value % unit == 0) return;
    throw t.error(key, fmt::format("is not a multiple of {}", of), fmt::format("{}", value),
                  fmt::format("a multiple of {}", unit),
                  fmt::format("e.g. {}", std::max(value / unit, std::int64_t{1}) * unit));
}

GasFields read_fields(const KeyedTable& t) {
    GasFields fields{.count = false, .rests = false, .momentum = false};
    for (const std::string& word : t.texts("fields")) {
        fields.count = fields.count || word == "count";
        fields.rests = fields.rests || word == "rests";
        fields.momentum = fields.momentum || word == "momentum";
    }
    return fields;
}

/// A frame holds downward momentum per bin in 16 bits: at most 4 half velocities per site, two wall
/// columns included.
void check_bin_capacity(const KeyedTable& t, const GasSampling& sampling) {
    const std::int64_t most = std::int64_t{4} * (sampling.width + 2) * sampling.bin;
    if (most <= std::numeric_limits<std::int16_t>::max()) return;
    throw t.error("bin", "is too large", fmt::format("{}", sampling.bin),
                  fmt::format("at most {} sites for this width",
                              std::numeric_limits<std::int16_t>::max() / 4 / (sampling.width + 2)));
}

/// Estimators keep a number or more of every frame.
void check_frames(const KeyedTable& t, const GasSampling& sampling) {
    if (sampling.frames() <= most_frames) return;
    throw t.error("every", "makes too many frames", fmt::format("{}", sampling.frames()),
                  fmt::format("at most {}", most_frames), "take frames less often");
}

const TableKeys& sample_keys() {
    static const TableKeys keys{
        .name = "sample",
        .keys = {{"bin", IntegerRule{1, longest}, "sites of a bin along the pipe", required},
                 {"replicas", IntegerRule{1, 512}, "of the ensemble", required},
                 {"burn_in", IntegerRule{0, most_steps}, "steps before the first frame"},
                 {"steps", IntegerRule{1, most_steps}, "from the first frame on", required},
                 {"every", IntegerRule{1, most_steps}, "steps between frames", required},
                 {"fields", toml_input::TextsRule{{"count", "rests", "momentum"}},
                  "what frames hold of each bin, default [\"count\"]"}}};
    return keys;
}

}  // namespace

std::vector<toml_input::Key> gas_sampling_keys() {
    return {{"length", IntegerRule{1, longest}, "L in sites, along the pipe", required},
            {"width", IntegerRule{3, widest}, "W in sites", required},
            {"sample", toml_input::TableRule{sample_keys}, "the run and its frames", required}};
}

GasSampling read_gas_sampling(const KeyedTable& scene) {
    GasSampling s;
    s.length = static_cast<int>(scene.integer("length"));
    s.width = static_cast<int>(scene.integer("width"));
    const KeyedTable t = scene.table("sample");
    s.bin = static_cast<int>(t.integer("bin"));
    s.replicas = static_cast<int>(t.integer("replicas"));
    if (t.has("burn_in")) s.burn_in = t.integer("burn_in");
    s.steps = t.integer("steps");
    s.every = t.integer("every");
    if (t.has("fields")) s.fields = read_fields(t);
    t.reject_unknown_keys();
    check_multiple(scene, "length", s.length, "the bin", s.bin);
    check_multiple(t, "steps", s.steps, "'every'", s.every);
    check_bin_capacity(t, s);
    check_frames(t, s);
    return s;
}

}  // namespace crossgrain::scene
