// The shift at which two density fields of an ensemble overlap most
// (Peng & Herrmann 1995, section III.B), in a periodic pipe.
#pragma once

#include "cases/measure/waves/binned_record.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace crossgrain::measure {

/// n_i minus its mean over the pipe, averaged over `rows` neighbouring bins (centred, >= 1).
/// Shape (bins, samples) in and out.
template <class T>
[[nodiscard]] std::vector<float> fluctuation(FieldShape shape, std::span<const T> density,
                                             std::size_t rows);

/// Adds c_s = sum_x a_x b_{x+s} to `overlap`, shape (bins, samples): c_s is greatest where b is a
/// moved by s bins.
void add_overlap(FieldShape shape, std::span<const float> a, std::span<const float> b,
                 std::span<float> overlap);

struct BestShift {
    std::size_t bins = 0;  ///< whole bins, 0 to bins - 1
    double refined = 0;    ///< in (-bins/2, bins/2], by the top of a parabola
    double overlap = 0;    ///< c at `bins`
};

/// Of one sample; the first of equals. The parabola is fitted by least squares to the points up to
/// `reach` bins away on both sides, >= 1: noise on a broad maximum would lock three points to the
/// grid.
[[nodiscard]] BestShift best_shift(FieldShape shape, std::span<const float> overlap,
                                   std::size_t sample, std::size_t reach = 1);

/// Moves b onto a by its best shift (whole bins), sample by sample, and returns the mean of a and
/// the moved b.
[[nodiscard]] std::vector<float> merge_overlapping(FieldShape shape, std::span<const float> a,
                                                   std::span<const float> b);

}  // namespace crossgrain::measure
