// Where the words of the bit-sliced engine are in memory. A word holds one state of one site for
// many replicas. Propagation moves no words: it changes, column by column, which stored column a
// column of the pipe is, and by how many rows it is rotated.
#pragma once

#include "native/lga/aligned_words.hpp"
#include "native/lga/geometry.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace crossgrain::lga {

class SlicedLattice {
  public:
    /// `lanes`: 64-bit lanes per word.
    SlicedLattice(const Geometry& geometry, std::size_t lanes)
        : rows_(geometry.rows()), columns_(geometry.columns()), lanes_(lanes),
          words_(aligned_words(size())) {
        std::fill_n(words_.get(), size(), 0U);
        for (auto& plane : places_) {
            for (int c = 0; c < columns_; ++c)
                plane.push_back({.column = c, .rotation = 0});
        }
    }

    /// The word of a state (0..5 movers, 6 rest) of a site.
    [[nodiscard]] std::uint64_t* word(int state, Site site) const {
        const auto& place =
            places_[static_cast<std::size_t>(state)][static_cast<std::size_t>(site.column)];
        int row = site.row + place.rotation;
        if (row >= rows_) row -= rows_;
        // Of a large pipe an int holds the number of a site, but not of a state.
        const std::int64_t stored = (std::int64_t{state} * columns_ + place.column) * rows_ + row;
        return words_.get() + static_cast<std::size_t>(stored) * lanes_;
    }

    /// Rows of a column that are contiguous in memory for all states: [first, last).
    struct Run {
        int first, last;
    };
    [[nodiscard]] std::vector<Run> runs(int column) const {
        std::array<int, directions + 2> cuts{};
        for (std::size_t i = 0; i < directions; ++i) {
            cuts[i] = rows_ - places_[i][static_cast<std::size_t>(column)].rotation;
        }
        cuts[directions] = 0;
        cuts[directions + 1] = rows_;
        std::ranges::sort(cuts);
        std::vector<Run> all;
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            if (cuts[i] < cuts[i + 1]) all.push_back({cuts[i], cuts[i + 1]});
        }
        return all;
    }

    /// Every mover goes to the neighbouring site. What reaches beyond the last columns comes back
    /// at the first ones, and likewise the rows: walls let nothing pass, and open ends are cleared
    /// by whoever has them.
    void propagate(const Geometry& geometry) {
        for (int i = 0; i < directions; ++i) {
            auto& plane = places_[static_cast<std::size_t>(i)];
            auto moved = plane;
            for (int c = 0; c < columns_; ++c) {
                const int to = (c + Geometry::column_step(i) + columns_) % columns_;
                auto place = plane[static_cast<std::size_t>(c)];
                place.rotation = (place.rotation - geometry.row_step(i, c) + rows_) % rows_;
                moved[static_cast<std::size_t>(to)] = place;
            }
            plane = moved;
        }
    }

  private:
    struct Place {
        int column, rotation;
    };
    [[nodiscard]] std::size_t size() const {
        return static_cast<std::size_t>(rest_bit + 1) * static_cast<std::size_t>(columns_) *
               static_cast<std::size_t>(rows_) * lanes_;
    }

    int rows_, columns_;
    std::size_t lanes_;
    AlignedWords words_;
    std::array<std::vector<Place>, rest_bit + 1> places_;
};

}  // namespace crossgrain::lga
