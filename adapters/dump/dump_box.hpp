// The box of a dump against the periods of a scene.
#pragma once

#include "cases/scene/scene.hpp"

#include <array>
#include <string>
#include <string_view>

namespace crossgrain::adapters::dump {

class Box {
  public:
    /// `item`: the line "ITEM: BOX BOUNDS [xy xz yz] bx by bz", each b two letters, p where an axis
    /// is periodic. Older writers leave the letters out, and nothing is checked then. Dumps of our
    /// own engines once had ss along a period of y; their bounds along z are "-0.5 0.5".
    /// Throws TrajectoryError where x or y is periodic and the scene's is not, or the reverse.
    Box(std::string_view item, const scene::Scene& scene);
    Box() = default;

    /// The next of the three lines "lo hi [tilt]". Throws TrajectoryError for what is no number, a
    /// tilted box, and a length that is not the scene's period.
    void take_bounds(std::string_view line);
    [[nodiscard]] bool is_complete() const noexcept { return axis_ == 3; }

  private:
    std::array<double, 3> periods_{};  ///< 0 where there is none, or nothing is checked
    std::size_t axis_ = 0;
    std::string mismatch_;  ///< holds unless the dump is one of those
};

}  // namespace crossgrain::adapters::dump
