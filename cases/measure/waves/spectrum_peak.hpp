// A peak in a noise spectrum: a power that the noise around it would hardly reach, with the number
// of frequencies that were searched.
//
// Of Gaussian noise every power P(f_k) is its expectation times chi^2/nu, nu = 2 for one
// periodogram and 2 n for the mean of n. A peak may be narrow or broad, so P, averaged with weights
// 1, 2, 1 (the skirts of Bartlett's window vanish at every second frequency), is averaged over
// w = 1, 3, 7, ..., 127 frequencies. The background of such a mean is the larger of the medians on
// its two sides, each over max(32, w) frequencies from a gap of w on (as many as there are, three
// at least), made a mean by the ratio of both for chi^2. Taking the larger one makes a peak a
// maximum: no spectrum that falls or rises has one, whatever its exponents and bends.
//
// Their ratio F has Fisher's distribution with nu (w/1.8 + 3/4) and nu m/3 degrees of freedom, m
// the frequencies of both sides: 9/5 is the loss of Bartlett's window, whose neighbouring powers
// are correlated (Welch, IEEE Trans. AU-15, 70 (1967)), 3/5 the efficiency of a median. The
// probability p of the largest F of N frequencies is Sidak's 1 - (1 - p)^N. A peak is significant
// if it is at most 0.001, F at least 1.3, which leaves out what a curved background does, and its
// centre lies within the search.
//
// Why not a multiple of the median, or of the scatter of log P: a factor of 20 is right for nu = 2
// and 2500 frequencies (2^-20 each, 1 in 400 records) and for nothing else; in the mean of 200
// periodograms a factor of 2 is beyond doubt. Measured (tests/cases/measure/waves): no false alarm
// in 1000 records each of noise with exponents 0, 1 and 1.86, nor in 100 of 32 samples each, which
// is no more than the stated one in 1000: the larger median is on the safe side. A wave that keeps
// its phase for 100 of 1024 intervals, as strong as the noise of a bin, is found in 100 of 100.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace crossgrain::measure {

struct PeakSearch {
    std::size_t first = 0;    ///< lowest and highest k looked at; from 5 on, below
    std::size_t last = 0;     ///< lie too few frequencies to tell a background
    double degrees = 2;       ///< nu of each power, >= 2
    std::size_t spectra = 1;  ///< how many such spectra are searched for one peak, >= 1
};

struct SpectrumPeak {
    double k = 0;            ///< centroid of what rises above the background
    double k_error = 0;      ///< its standard error by the scatter of chi^2 over the peak
    double ratio = 0;        ///< F
    double false_alarm = 1;  ///< probability that noise has such a peak somewhere in the search
    double excess = 0;       ///< power of the peak above the background, summed over its width
    bool significant = false;

    /// The false alarm as so many standard deviations of a normal distribution, 37 at most.
    [[nodiscard]] double sigmas() const;
};

inline constexpr double largest_false_alarm = 1e-3;
inline constexpr double least_peak_ratio = 1.3;

/// The most likely peak of power[k] = P(f_k), k from 0 on, from a record that was multiplied with
/// Bartlett's window. Nothing if no frequency of the search has three others on both sides, or no
/// background that is positive.
[[nodiscard]] std::optional<SpectrumPeak> find_peak(std::span<const double> power,
                                                    const PeakSearch& search);

}  // namespace crossgrain::measure
