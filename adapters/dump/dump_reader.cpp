#include "adapters/dump/dump_reader.hpp"

#include "adapters/dump/dump_box.hpp"
#include "adapters/dump/dump_columns.hpp"
#include "adapters/dump/dump_number.hpp"
#include "adapters/dump/zstd_file.hpp"
#include "native/base/errors.hpp"
#include "native/base/input_file.hpp"
#include "native/base/printable.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace crossgrain::adapters::dump {

namespace {

constexpr std::size_t longest_quoted = 60;

std::int64_t parse_integer(std::string_view line, const char* what) {
    while (!line.empty() && line.front() == ' ')
        line.remove_prefix(1);
    while (!line.empty() && line.back() == ' ')
        line.remove_suffix(1);
    if (const auto value = dump_number<std::int64_t>(line)) return *value;
    throw TrajectoryError(fmt::format("'{}' is not a {}", printable(line, longest_quoted), what));
}

}  // namespace

/// What a line must be follows from the lines before it.
struct DumpReader::State {
    enum class Expects { item, skipped_value, time, step, atom_count, bounds, row };

    State(const scene::Scene& given_scene, scene::FrameSink given_sink)
        : scene(given_scene), sink(std::move(given_sink)), grains(given_scene.grain_count()),
          atoms(grains + (given_scene.has_free_lid() ? 1 : 0)), x(atoms), y(atoms), vx(atoms),
          vy(atoms), omega(atoms), z(grains), seen_in(atoms, 0) {}

    /// Takes a line without its end; names it when something is wrong with it.
    void take_line(std::string_view line);
    static void refuse_what_is_no_text(std::string_view beginning);
    /// More of a line that has not ended yet.
    void take_part(std::string_view part);

    [[nodiscard]] std::string place() const {
        return step ? fmt::format("frame at step {}", *step)
                    : fmt::format("frame {}", frames_complete);
    }

    const scene::Scene& scene;
    scene::FrameSink sink;
    std::size_t grains, atoms;

    std::string partial_line;
    std::int64_t line_number = 0;
    std::int64_t frames_complete = 0;
    Expects expects = Expects::item;
    Box box;
    std::optional<double> time;        // of the frame that is being read, if the dump tells it
    std::optional<std::int64_t> step;  // of the frame that is being read
    bool counted = false;
    bool bounded = false;
    bool has_units = false;
    Columns columns;
    std::size_t rows_left = 0;

    std::vector<double> x, y, vx, vy, omega;  // shape (grains + lid), by id
    std::vector<double> z;              // shape (grains): of the first frame, where the dump has it
    std::vector<std::int64_t> seen_in;  // 1 + number of the frame in which an id was last seen

  private:
    void interpret(std::string_view line);
    void take_item(std::string_view line);
    [[noreturn]] static void refuse_place(std::string_view line);
    void take_atom_count(std::string_view line);
    void take_columns(std::string_view names);
    void take_row(std::string_view line);
    void hold_against_scene(const Row& row, std::size_t grain);
    void check_time() const;
    void emit();
};

void DumpReader::State::refuse_what_is_no_text(std::string_view beginning) {
    if (const auto reason = why_not_text(beginning)) {
        throw TrajectoryError(fmt::format("dump {}, not a LAMMPS text dump", *reason));
    }
}

void DumpReader::State::take_part(std::string_view part) {
    const std::size_t room = longest_line - partial_line.size();
    partial_line += part.substr(0, room);
    if (part.size() <= room) return;
    if (line_number == 0) refuse_what_is_no_text(partial_line);
    throw TrajectoryError(fmt::format("dump, line {}: longer than {} bytes: '{}'", line_number + 1,
                                      longest_line, printable(partial_line, longest_quoted)));
}

void DumpReader::State::take_line(std::string_view line) {
    if (line_number == 0) {
        refuse_what_is_no_text(line);
        if (line.starts_with(byte_order_mark)) line.remove_prefix(byte_order_mark.size());
    }
    ++line_number;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    try {
        interpret(line);
    } catch (const TrajectoryError& error) {
        throw TrajectoryError(fmt::format("dump, line {}: {}", line_number, error.what()));
    }
    // Outside: what the sink throws about a frame is not about a line.
    if (expects == Expects::row && rows_left == 0) emit();
}

void DumpReader::State::interpret(std::string_view line) {
    switch (expects) {
    case Expects::row:
        return take_row(line);
    case Expects::item:
        return take_item(line);
    case Expects::skipped_value:
        expects = Expects::item;
        return;
    case Expects::time:
        time = dump_number<double>(line);
        if (!time) {
            throw TrajectoryError(
                fmt::format("'{}' is not a time", printable(line, longest_quoted)));
        }
        expects = Expects::item;
        return;
    case Expects::step:
        step = parse_integer(line, "step");
        expects = Expects::item;
        return;
    case Expects::atom_count:
        return take_atom_count(line);
    case Expects::bounds:
        if (line.starts_with("ITEM:")) return refuse_place(line);
        box.take_bounds(line);
        if (box.is_complete()) expects = Expects::item;
        return;
    }
}

void DumpReader::State::take_item(std::string_view line) {
    constexpr std::string_view atoms_item = "ITEM: ATOMS";
    if (line.starts_with(atoms_item) && bounded) {
        take_columns(line.substr(atoms_item.size()));
    } else if (line.starts_with("ITEM: UNITS") && !has_units && !step) {
        has_units = true;
        expects = Expects::skipped_value;
    } else if (line.starts_with("ITEM: TIME") && !line.starts_with("ITEM: TIMESTEP") && !time &&
               !step) {
        expects = Expects::time;
    } else if (line.starts_with("ITEM: TIMESTEP") && !step) {
        expects = Expects::step;
    } else if (line.starts_with("ITEM: NUMBER OF ATOMS") && step && !counted) {
        expects = Expects::atom_count;
    } else if (line.starts_with("ITEM: BOX BOUNDS") && counted && !bounded) {
        bounded = true;
        box = Box(line, scene);
        expects = Expects::bounds;
    } else if (line.find_first_not_of(" \t") == std::string_view::npos) {
        throw TrajectoryError("a blank line is out of place");
    } else {
        refuse_place(line);
    }
}

void DumpReader::State::refuse_place(std::string_view line) {
    throw TrajectoryError(fmt::format(
        "'{}' is out of place (a frame is ITEM: TIMESTEP, NUMBER OF ATOMS, BOX BOUNDS, ATOMS)",
        printable(line, longest_quoted)));
}

void DumpReader::State::take_atom_count(std::string_view line) {
    const std::int64_t count = parse_integer(line, "number of atoms");
    if (count != static_cast<std::int64_t>(atoms)) {
        throw TrajectoryError(fmt::format("{} holds {} atoms, {} expected ({} grains{})", place(),
                                          count, atoms, grains,
                                          atoms > grains ? " and a lid" : ""));
    }
    counted = true;
    expects = Expects::item;
}

void DumpReader::State::take_columns(std::string_view names) {
    columns = Columns(names, scene.periodic_x.has_value(), scene.periodic_y.has_value(),
                      scene.has_friction());
    rows_left = atoms;
    expects = Expects::row;
    check_time();
}

/// ITEM: TIME tells the time step that the run really had.
void DumpReader::State::check_time() const {
    constexpr double six_digits = 1e-5;
    const double expected = static_cast<double>(*step) * scene.dt;
    if (!time || std::abs(*time - expected) <= six_digits * std::abs(expected)) return;
    throw TrajectoryError(fmt::format("{} is of time {:g}; with the scene's dt = {:g} it is {:g}",
                                      place(), *time, scene.dt, expected));
}

void DumpReader::State::take_row(std::string_view line) {
    if (line.starts_with("ITEM:")) {
        throw TrajectoryError(
            fmt::format("{} has {} rows, {} expected", place(), atoms - rows_left, atoms));
    }
    const Row row = columns.read(line);
    if (row.id < 1 || row.id > static_cast<std::int64_t>(atoms)) {
        throw TrajectoryError(fmt::format("unknown id {} (1 to {} expected)", row.id, atoms));
    }
    const auto i = static_cast<std::size_t>(row.id - 1);
    if (seen_in[i] == frames_complete + 1) {
        throw TrajectoryError(fmt::format("id {} appears twice in the {}", row.id, place()));
    }
    seen_in[i] = frames_complete + 1;
    x[i] = row[Column::x];
    y[i] = row[Column::y];
    vx[i] = row[Column::vx];
    vy[i] = row[Column::vy];
    omega[i] = row[Column::omega];
    if (i < grains) hold_against_scene(row, i);
    --rows_left;
}

/// What the scene knows of a grain beside its motion: a disc of its own size and mass in a plane.
void DumpReader::State::hold_against_scene(const Row& row, std::size_t grain) {
    const auto require = [&](Column column, const char* what, double expected) {
        constexpr double six_digits = 1e-5;
        if (!columns.has(column)) return;
        if (std::abs(row[column] - expected) <= six_digits * std::abs(expected)) return;
        throw TrajectoryError(fmt::format("{} of id {} is {:g}, the scene's is {:g}", what, row.id,
                                          row[column], expected));
    };
    require(Column::radius, "radius", scene.grains.diameter_of(grain) / 2);
    require(Column::mass, "mass", scene.grains.mass_of(grain));
    require(Column::vz, "velocity along z", 0);
    if (!columns.has(Column::z)) return;
    if (frames_complete == 0) z[grain] = row[Column::z];
    require(Column::z, "z", z[grain]);
}

void DumpReader::State::emit() {
    const auto of_grains = [this](const std::vector<double>& values) {
        return std::span<const double>(values.data(), grains);
    };
    scene::Frame frame{.step = *step,
                       .time = static_cast<double>(*step) * scene.dt,
                       .x = of_grains(x),
                       .y = of_grains(y),
                       .vx = of_grains(vx),
                       .vy = of_grains(vy),
                       .lid = {}};
    if (atoms > grains) frame.lid = {.height = y[grains], .velocity = vy[grains]};
    if (scene.has_friction()) frame.omega = of_grains(omega);
    ++frames_complete;
    step.reset();
    time.reset();
    counted = bounded = has_units = false;
    expects = Expects::item;
    sink(frame);
}

DumpReader::DumpReader(const scene::Scene& scene, scene::FrameSink sink)
    : state_(std::make_unique<State>(scene, std::move(sink))) {}

DumpReader::~DumpReader() = default;

void DumpReader::feed(std::string_view bytes) {
    while (!bytes.empty()) {
        const auto* const end =
            static_cast<const char*>(std::memchr(bytes.data(), '\n', bytes.size()));
        if (end == nullptr) return state_->take_part(bytes);
        const auto length = static_cast<std::size_t>(end - bytes.data());
        if (state_->partial_line.empty() && length <= longest_line) {
            state_->take_line(bytes.substr(0, length));
        } else {
            state_->take_part(bytes.substr(0, length));
            state_->take_line(std::exchange(state_->partial_line, {}));
        }
        bytes.remove_prefix(length + 1);
    }
}

void DumpReader::finish() {
    const State& s = *state_;
    const bool between_frames = s.expects == State::Expects::item && !s.step && !s.counted;
    if (s.line_number == 0) State::refuse_what_is_no_text(s.partial_line);
    if (!between_frames || !s.partial_line.empty()) {
        throw TrajectoryError(fmt::format("dump ends in the middle of the {} (after line {})",
                                          s.place(), s.line_number));
    }
    if (s.frames_complete == 0) throw TrajectoryError("dump holds no frame");
}

void read_dump_file(const std::filesystem::path& file, const scene::Scene& scene,
                    const scene::FrameSink& sink, std::stop_token stop) {
    InputFile in(file.string(), "a LAMMPS text dump", std::move(stop));
    DumpReader reader(scene, sink);
    std::optional<ZstdUnpacker> packed;
    if (file.extension() == zstd_extension)
        packed.emplace([&](std::string_view text) { reader.feed(text); });
    std::vector<char> block(std::size_t{1} << 20);
    while (const std::size_t got = in.read(block)) {
        const std::string_view bytes(block.data(), got);
        packed ? packed->feed(bytes) : reader.feed(bytes);
    }
    if (packed) packed->finish();
    reader.finish();
}

}  // namespace crossgrain::adapters::dump
