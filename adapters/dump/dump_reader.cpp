#include "adapters/dump/dump_reader.hpp"

#include "adapters/dump/dump_columns.hpp"
#include "native/base/errors.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <utility>
#include <vector>

namespace crossgrain::adapters::dump {

/// Bytes are cut into lines; what a line must be follows from the lines before it.
struct DumpReader::State {
    enum class Expects { item, skipped_value, timestep, atom_count, bounds, row };

    State(const scene::Scene& given_scene, scene::FrameSink given_sink)
        : scene(given_scene), sink(std::move(given_sink)), grains(given_scene.grain_count()),
          atoms(grains + (given_scene.has_free_lid() ? 1 : 0)), x(atoms), y(atoms), vx(atoms),
          vy(atoms), seen_in(atoms, 0) {}

    void take_line(std::string_view line);
    void take_item(std::string_view line);
    void take_atom_count(std::string_view line);
    void take_row(std::string_view line);
    void emit();

    // A copy: the reader outlives nobody's scene by accident. Only what is needed is read.
    const scene::Scene& scene;
    scene::FrameSink sink;
    std::size_t grains, atoms;

    std::string partial_line;
    std::int64_t line_number = 0;
    Expects expects = Expects::item;
    int bounds_left = 0;
    std::optional<std::int64_t> step;
    bool counted = false;
    Columns columns;
    std::size_t rows_left = 0;
    std::int64_t frame_number = 0;  // 1-based while its rows are read

    std::vector<double> x, y, vx, vy;       // shape (grains + lid), by id
    std::vector<std::int64_t> seen_in;      // frame in which an id was last seen
};

namespace {

std::int64_t parse_integer(std::string_view line, const char* what) {
    while (!line.empty() && line.front() == ' ') line.remove_prefix(1);
    while (!line.empty() && line.back() == ' ') line.remove_suffix(1);
    std::int64_t value = 0;
    const char* const end = line.data() + line.size();
    const auto [stop, error] = std::from_chars(line.data(), end, value);
    if (error != std::errc{} || stop != end) {
        throw TrajectoryError(fmt::format("'{}' is not a {}", line, what));
    }
    return value;
}

}  // namespace
