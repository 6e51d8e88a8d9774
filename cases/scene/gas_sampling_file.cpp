#include "cases/scene/gas_sampling_file.hpp"

#include "cases/scene/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

namespace crossgrain::scene {
namespace {

using toml_input::TomlTable;

void check_multiple(const TomlTable& t, const char* key, std::int64_t value, const char* of,
                    std::int64_t unit) {
    if (value % unit == 0) return;
    throw t.error(key, fmt::format("is not a multiple of {}", of), fmt::format("{}", value),
                  fmt::format("a multiple of {}", unit),
                  fmt::format("e.g. {}", std::max(value / unit, std::int64_t{1}) * unit));
}

GasFields read_fields(const TomlTable& t) {
    static const std::array<std::string, 3> known{"count", "rests", "momentum"};
    GasFields fields{.count = false, .rests = false, .momentum = false};
    for (const std::string& word : t.texts("fields")) {
        if (std::ranges::find(known, word) == known.end()) {
            const auto near = toml_input::nearest(word, known);
            throw t.error("fields", "names an unknown field", fmt::format("\"{}\"", word),
                          "some of \"count\", \"rests\", \"momentum\"",
                          near ? fmt::format("did you mean \"{}\"?", *near) : "");
        }
        fields.count = fields.count || word == "count";
        fields.rests = fields.rests || word == "rests";
        fields.momentum = fields.momentum || word == "momentum";
    }
    return fields;
}

/// A frame holds downward momentum per bin in 16 bits: at most 4 half velocities per site, two wall
/// columns included.
void check_bin_capacity(const TomlTable& t, const GasSampling& sampling) {
    const std::int64_t most = std::int64_t{4} * (sampling.width + 2) * sampling.bin;
    if (most <= std::numeric_limits<std::int16_t>::max()) return;
    throw t.error("bin", "is too large", fmt::format("{}", sampling.bin),
                  fmt::format("at most {} sites for this width",
                              std::numeric_limits<std::int16_t>::max() / 4 / (sampling.width + 2)));
}

/// Estimators keep a number or more of every frame.
void check_frames(const TomlTable& t, const GasSampling& sampling) {
    if (sampling.frames() <= most_frames) return;
    throw t.error("every", "makes too many frames", fmt::format("{}", sampling.frames()),
                  fmt::format("at most {}", most_frames), "take frames less often");
}

}  // namespace

GasSampling read_gas_sampling(const TomlTable& scene) {
    constexpr std::int64_t longest = 10'000'000, widest = 8'000;
    GasSampling s;
    s.length = static_cast<int>(scene.integer("length", 1, longest));
    s.width = static_cast<int>(scene.integer("width", 3, widest));
    const TomlTable t = scene.table("sample");
    s.bin = static_cast<int>(t.integer("bin", 1, longest));
    s.replicas = static_cast<int>(t.integer("replicas", 1, 512));
    if (t.has("burn_in")) s.burn_in = t.integer("burn_in", 0, most_steps);
    s.steps = t.integer("steps", 1, most_steps);
    s.every = t.integer("every", 1, most_steps);
    if (t.has("fields")) s.fields = read_fields(t);
    t.reject_unknown_keys();
    check_multiple(scene, "length", s.length, "the bin", s.bin);
    check_multiple(t, "steps", s.steps, "'every'", s.every);
    check_bin_capacity(t, s);
    check_frames(t, s);
    return s;
}

}  // namespace crossgrain::scene
