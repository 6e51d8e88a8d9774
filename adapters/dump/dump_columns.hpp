// Which column of a dump holds what, and the reading of one row.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace crossgrain::adapters::dump {

/// What a column may hold; the names are those of LAMMPS.
enum class Column : std::uint8_t { x, y, vx, vy, omega, z, vz, radius, mass };
inline constexpr std::size_t column_count = 9;

struct Row {
    std::int64_t id = 0;
    std::array<double, column_count> values{};  ///< by Column; 0 where has() is false

    [[nodiscard]] double operator[](Column column) const {
        return values[static_cast<std::size_t>(column)];
    }
};

class Columns {
  public:
    /// `names`: what follows "ITEM: ATOMS", e.g. "id type xu yu vx vy". Along a periodic axis only
    /// the unwrapped position will do, otherwise x may stand for xu and y for yu.
    /// `spins`: whether the column omegaz is needed. Positions and velocities along z, radii and
    /// masses are read where there are any. Throws TrajectoryError when a column is missing.
    Columns(std::string_view names, bool periodic_x, bool periodic_y, bool spins);
    Columns() = default;

    /// Throws TrajectoryError for a short row, a value that is not a number or is not finite.
    [[nodiscard]] Row read(std::string_view line) const;
    [[nodiscard]] bool has(Column column) const {
        return present_[static_cast<std::size_t>(column)];
    }

  private:
    static constexpr std::uint8_t ignored = column_count, id = column_count + 1;

    std::vector<std::uint8_t> meanings_;  // a Column, or one of these; up to the last that is read
    std::array<bool, column_count> present_{};
};

}  // namespace crossgrain::adapters::dump
