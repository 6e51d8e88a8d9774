// A run with all its parts filled in, and the comparison of two results bit for bit.
#pragma once

#include "adapters/run/store/store.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace crossgrain::tests {

/// Numbers that a short or a decimal format would change.
inline const std::vector<double> awkward_numbers{0.0,
                                                 -0.0,
                                                 0.1 + 0.2,
                                                 -1.0 / 3,
                                                 5e-324,
                                                 -2.2250738585072014e-308,
                                                 std::numeric_limits<double>::max(),
                                                 std::numeric_limits<double>::epsilon(),
                                                 1e-17,
                                                 9007199254740993.0,
                                                 65504.0,
                                                 0.5};

inline std::vector<std::array<std::uint8_t, 3>> all_greys() {
    std::vector<std::array<std::uint8_t, 3>> palette(256);
    for (std::size_t i = 0; i < palette.size(); ++i)
        palette[i].fill(static_cast<std::uint8_t>(255 - i));
    return palette;
}

inline store::RunRecord stored_run(const std::string& key = "key", double value = 1.0 / 3) {
    store::RunRecord run;
    run.key = key;
    run.case_name = "small";
    run.variant = "clip-all";
    run.rung = 3;
    run.code = "native-dem";
    run.version = "0.1.0 (engine 1a2b3c4d)";
    run.replica = 2;
    run.seed = 18446744073709551615U;
    run.status = store::RunStatus::ok;
    run.settings_json = R"({"dt":0.001,"N":16})";
    run.cpu_s = 1.25;
    run.wall_s = 1.5;
    run.work = 1e300;
    run.created = "2026-01-31T12:00:00Z";
    run.results.measurements = {{.observable = "restitution",
                                 .value = value,
                                 .standard_error = 5e-324,
                                 .systematic = 1e-17,
                                 .n = 64,
                                 .unit = "l/t",
                                 .settings = {{"k_min", 1.0}, {"k_max", 0.1 + 0.2}}},
                                {.observable = "no scatter", .value = -0.0, .settings = {}}};
    run.results.series = {
        {.name = "lid-height", .columns = {"t", "h"}, .values = {awkward_numbers, awkward_numbers}},
        {.name = "empty", .columns = {"t"}, .values = {{}}}};
    run.results.series[0].units = {"t", "l"};
    run.results.snapshots = {{.time = 0.1, .x = awkward_numbers, .y = awkward_numbers},
                             {.time = 1e300, .x = {}, .y = {}}};
    run.results.pictures = {{.name = "space-time",
                             .title = "density n(x, t), \"t\" downward",
                             .width = 3,
                             .height = 2,
                             .pixels = {0, 1, 2, 2, 0, 255},
                             .palette = all_greys()}};
    run.results.findings = {{.name = "state", .label = "ageing", .detail = "drifts by 3 sigma"},
                            {.name = "wave", .label = "", .detail = ""}};
    return run;
}

inline bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) return false;
    }
    return true;
}

inline bool same_bits(const measure::Measurement& a, const measure::Measurement& b) {
    return a.observable == b.observable &&
           same_bits({a.value, a.standard_error, a.systematic},
                     {b.value, b.standard_error, b.systematic}) &&
           a.n == b.n && a.unit == b.unit && a.settings == b.settings;
}

inline bool same(const measure::Picture& a, const measure::Picture& b) {
    return a.name == b.name && a.title == b.title && a.width == b.width && a.height == b.height &&
           a.pixels == b.pixels && a.palette == b.palette;
}

inline bool same(const measure::Finding& a, const measure::Finding& b) {
    return a.name == b.name && a.label == b.label && a.detail == b.detail;
}

inline bool same_bits(const measure::Results& a, const measure::Results& b) {
    if (a.measurements.size() != b.measurements.size() || a.series.size() != b.series.size() ||
        a.snapshots.size() != b.snapshots.size()) {
        return false;
    }
    bool same = std::ranges::equal(a.pictures, b.pictures,
                                   [](auto& p, auto& q) { return tests::same(p, q); }) &&
                std::ranges::equal(a.findings, b.findings,
                                   [](auto& p, auto& q) { return tests::same(p, q); });
    for (std::size_t i = 0; i < a.measurements.size(); ++i) {
        same = same && same_bits(a.measurements[i], b.measurements[i]);
    }
    for (std::size_t i = 0; i < a.series.size(); ++i) {
        const auto &p = a.series[i], &q = b.series[i];
        same = same && p.name == q.name && p.columns == q.columns && p.units == q.units &&
               p.values.size() == q.values.size();
        for (std::size_t c = 0; same && c < p.values.size(); ++c)
            same = same_bits(p.values[c], q.values[c]);
    }
    for (std::size_t i = 0; i < a.snapshots.size(); ++i) {
        const auto &p = a.snapshots[i], &q = b.snapshots[i];
        same = same && same_bits({p.time}, {q.time}) && same_bits(p.x, q.x) && same_bits(p.y, q.y);
    }
    return same;
}

}  // namespace crossgrain::tests
