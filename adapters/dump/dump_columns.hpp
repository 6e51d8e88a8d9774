// Which column of a dump holds what, and the reading of one row.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace crossgrain::adapters::dump {

struct Row {
    std::int64_t id = 0;
    std::array<double, 5> values{};  ///< x, y, vx, vy, omega (0 when it is not asked for)
};

class Columns {
  public:
    /// `names`: what follows "ITEM: ATOMS", e.g. "id type xu yu vx vy". Along a periodic axis only
    /// the unwrapped position will do, otherwise x may stand for xu and y for yu.
    /// `spins`: whether the column omegaz is needed. Throws TrajectoryError when a column is
    /// missing.
    Columns(std::string_view names, bool periodic_x, bool periodic_y, bool spins);
    Columns() = default;

    /// Throws TrajectoryError for a short row, a value that is not a number or is not finite.
    [[nodiscard]] Row read(std::string_view line) const;

  private:
    enum class Meaning : std::uint8_t { ignored, id, x, y, vx, vy, omega };
    std::vector<Meaning> meanings_;  // up to the last column that is needed
};

}  // namespace crossgrain::adapters::dump
