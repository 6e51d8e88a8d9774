// What a run leaves behind: numbers with errors, curves, and a few snapshots for comparison.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace crossgrain::measure {

/// One number with its errors.
struct Measurement {
    std::string observable;  ///< name in the catalogue of observables
    double value = 0;
    double standard_error = 0;  ///< statistical; 0 for a number without scatter
    double systematic = 0;      ///< e.g. spread over fit windows; 0 when not applicable
    std::size_t n = 1;          ///< independent samples behind the value
    std::string unit = "1";     ///< reduced units, e.g. "t"
    std::map<std::string, double> settings;  ///< e.g. {"k_min", 1}, {"k_max", 16}
};

/// A curve or a table: columns of equal length.
struct Series {
    std::string name;                         ///< e.g. "lid-height"
    std::vector<std::string> columns;         ///< e.g. {"t", "h"}
    std::vector<std::vector<double>> values;  ///< shape (columns, rows)
    std::vector<std::string> units = {};      ///< parallel to columns; empty if not stated
};

/// State at one time, for trajectory comparison between codes. Arrays have shape (grains).
struct Snapshot {
    double time = 0;
    std::vector<double> x, y;
};

/// A picture as palette indices, row by row from the top.
struct Picture {
    std::string name;   ///< e.g. "space-time"
    std::string title;  ///< with what the axes and colours mean
    std::size_t width = 0, height = 0;
    std::vector<std::uint8_t> pixels;                  ///< shape (height, width)
    std::vector<std::array<std::uint8_t, 3>> palette;  ///< red, green, blue; up to 256
};

/// What a run was found to be, in a word: e.g. {"state", "ageing", "density drifts by 3 sigma"}.
struct Finding {
    std::string name;
    std::string label;
    std::string detail;
};

struct Results {
    std::vector<Measurement> measurements;
    std::vector<Series> series;
    std::vector<Snapshot> snapshots;
    std::vector<Picture> pictures;
    std::vector<Finding> findings;
};

}  // namespace crossgrain::measure
