// A peak in a noise spectrum: where it rises above what its neighbourhood leads one to expect.
//
// Around each frequency k the neighbourhood is k +- max(12, k/5), a straight line in log P against
// log k through the medians of its two halves is the expectation, and 1.4826 times the median
// absolute deviation from the line is the scatter sigma. The peak is where (log P - line) is
// greatest; it is significant if that is at least 7 sigma and log 1.3. Power-law backgrounds of any
// exponent are straight lines and give none.
//
// A broad peak, or one with the skirts of the window, fills its own neighbourhood and has sigma of
// its size. If nothing was significant, a peak is looked for that stands above what lies farther
// off: the expectation is the larger of the medians over (k/2, 3k/4) and (5k/4, 3k/2), sigma the
// scatter of second differences of log P (from 1.4826 times the median of their size), which no
// smooth shape has; for it P is averaged with weights 1, 2, 1, because the skirts of Bartlett's
// window are zero at every second frequency. It must be at least 7 sigma and log 3.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace crossgrain::measure {

struct PeakSearch {
    std::size_t first = 0;  ///< lowest and highest k looked at; from 13 on
    std::size_t last = 0;
    double least_sigma = 7;
    double least_ratio = 1.3;
    double least_broad_ratio = 3;
};

struct SpectrumPeak {
    double k = 0;       ///< centroid of what rises above a tenth of the peak's height
    double ratio = 0;   ///< power over the expectation, at the maximum
    double sigmas = 0;  ///< height of log P over the scatter
    bool significant = false;
};

/// power[k], all of it positive. Nothing if the neighbourhood of the highest k is beyond the
/// spectrum's end, or if the search is empty.
[[nodiscard]] std::optional<SpectrumPeak> find_peak(std::span<const double> power,
                                                    const PeakSearch& search);

}  // namespace crossgrain::measure
