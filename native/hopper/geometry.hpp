// The sites of a hopper. Triangular lattice with one vertical axis and spacing 1: column c at
// x = c sqrt(3)/2, half-level k at y = k/2, a site where c + k + N - 1 is even. The hopper is
// |x| <= (N - 1) sqrt(3)/2 + y tan(theta/2), so the outlet has exactly N sites.
//
//   local numbering (Gremaud, Fig. 4), as steps (dk, dc):
//            3 (+2, 0)
//   2 (+1,-1)         4 (+1,+1)
//            1
//   7 (-1,-1)         5 (-1,+1)
//            6 (-2, 0)
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace crossgrain::hopper {

/// Sites of one half-level: columns first, first + 2, ..., last.
struct Level {
    std::int32_t first = 0;
    std::int32_t last = 0;
    std::size_t offset = 0;  ///< number of the first site: sites are counted level by level
    [[nodiscard]] std::size_t sites() const noexcept {
        return static_cast<std::size_t>((last - first) / 2) + 1;
    }
};

/// State of a site outside the hopper; 0 is empty, 1 to 3 are orientations.
inline constexpr std::uint8_t outside = 4;

/// Fields are stored with a margin on all sides, in one array in which every neighbour lies a
/// constant number of places away from its site.
class Geometry {
  public:
    /// outlet >= 2, levels >= 1, angle in (0, 180) degrees: see check() of parameters.hpp.
    Geometry(int outlet, int levels, double angle);

    [[nodiscard]] const std::vector<Level>& levels() const noexcept { return levels_; }
    [[nodiscard]] std::size_t sites() const noexcept { return sites_; }

    /// Length of a stored field.
    [[nodiscard]] std::size_t stored() const noexcept;
    /// Place of the site (k, c) in a stored field; -2 <= k < levels + 2.
    [[nodiscard]] std::size_t place(std::int32_t k, std::int32_t c) const noexcept {
        return static_cast<std::size_t>(((k + margin) * pitch_ + c + half_width_) / 2);
    }
    /// Place of the first site of level k.
    [[nodiscard]] std::size_t place_of_level(std::size_t k) const noexcept {
        return place(static_cast<std::int32_t>(k), levels_[k].first);
    }
    /// From a site to its neighbour j = 2..7 of the local numbering, in places.
    [[nodiscard]] std::ptrdiff_t step(int j) const noexcept {
        return steps_[static_cast<std::size_t>(j)];
    }
    /// Empty ghosts below the outlet and above the filling, `outside` elsewhere, sites empty.
    [[nodiscard]] std::vector<std::uint8_t> empty_field() const;

  private:
    static constexpr std::int64_t margin = 2;  // half-levels below and above

    std::vector<Level> levels_;
    std::size_t sites_ = 0;
    std::array<Level, 4> ghosts_{};  // half-levels -2, -1, levels, levels + 1
    std::int64_t half_width_ = 0;    // columns to either side
    std::int64_t pitch_ = 0;         // places of two half-levels, odd
    std::array<std::ptrdiff_t, 8> steps_{};
};

/// Sites of the hopper without building it, for a check of size. Not rounded: may be any number.
[[nodiscard]] double approximate_sites(int outlet, int levels, double angle);

}  // namespace crossgrain::hopper
