// Streaming reader of LAMMPS text dumps, the neutral trajectory format: bytes in, frames out.
// Columns are found by their names, so their order does not matter; rows are put in order by id.
#pragma once

#include "cases/scene/frame.hpp"
#include "cases/scene/scene.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

namespace crossgrain::adapters::dump {

/// No dump of any scene has a longer line.
inline constexpr std::size_t longest_line = std::size_t{1} << 16;

/// Needs the columns id, xu, yu, vx, vy, and omegaz when the scene has friction; other columns are
/// ignored, but for z and vz, which must not move, and radius and mass, which must be the scene's
/// (six digits). Grains have ids 1 ... N in the
/// order of the scene; a free lid is the row with id N + 1, whose yu and vy are its height and
/// velocity. A dump with x (y) instead of xu (yu) is accepted unless the scene is periodic in x
/// (y). The header may hold ITEM: UNITS, which is skipped, and ITEM: TIME, which must be step * dt.
///
/// Throws TrajectoryError (with the line number) for: a missing column, a wrong number of atoms, a
/// duplicate or unknown id, a value that is not a number or not finite, a header out of place, a
/// box that is not the scene's (dump_box.hpp).
class DumpReader {
  public:
    /// Feeds every complete frame to `sink`. `scene` gives the number of grains, dt and the lid.
    DumpReader(const scene::Scene& scene, scene::FrameSink sink);
    ~DumpReader();
    DumpReader(const DumpReader&) = delete;
    DumpReader& operator=(const DumpReader&) = delete;

    /// Throws also for what is no text (compressed, binary, UTF-16) and for a line of more than
    /// longest_line bytes, as soon as so many have come. A byte order mark is skipped.
    void feed(std::string_view bytes);
    /// Throws TrajectoryError if the dump ends in the middle of a frame or holds none.
    void finish();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Reads a whole dump file, or a pipe, through a DumpReader; one whose name ends in ".zst" is
/// unpacked meanwhile (ZstdUnpacker). Throws CaseError if it cannot be opened, Interrupted if asked
/// to stop.
void read_dump_file(const std::filesystem::path& file, const scene::Scene& scene,
                    const scene::FrameSink& sink, std::stop_token stop = {});

}  // namespace crossgrain::adapters::dump
