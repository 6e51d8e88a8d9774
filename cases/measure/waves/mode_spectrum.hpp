// The velocity of density waves from the longest waves along a pipe,
//
//   n_k(t) = sum_i n_i(t) exp(-2 pi i k (i + 1/2)/K),   k = 1 to 4,
//
// whose power spectrum over segments of M fields, each minus its mean and multiplied with
// Bartlett's window, is averaged over segments and, for an ensemble, over samples. What moves at v
// turns n_k at the frequency -k v/L, so that both directions are told apart. Of Gaussian noise each
// power has two degrees of freedom per segment and sample, and a wave is a peak by
// spectrum_peak.hpp in any of the eight spectra (k and direction): of the significant ones that
// with the most power.
//
// The bins' own spectrum (Peng & Herrmann 1995, section III.D), from which v = L f is read for
// k = 1, is the sum of these spectra over all k. It has no sign, and the degrees of freedom of a
// mean over bins are those of the few waves that are strong, which nobody knows beforehand.
#pragma once

#include "cases/measure/results.hpp"
#include "cases/measure/statistics/pair_transform.hpp"
#include "cases/measure/waves/binned_record.hpp"
#include "cases/measure/waves/record_segments.hpp"
#include "cases/measure/waves/spectrum_peak.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace crossgrain::measure {

/// Speeds at which a wave is looked for, up and down, in the record's units, 0 <= least < most.
struct SpeedBand {
    double least = 0, most = 0;
};

struct WavePeak {
    std::size_t k = 1;       ///< waves per pipe
    double velocity = 0;     ///< along gravity
    double fundamental = 0;  ///< |v| T/L, at which the pattern goes round, cycles per interval
    SpectrumPeak peak;
};

class ModeSpectrum {
  public:
    static constexpr std::size_t modes = 4;

    /// `points` is M, even; a record of at least nine bins.
    ModeSpectrum(BinnedRecord record, std::size_t points, SpeedBand band);

    /// A full segment of all bins of the record.
    void add(const RecordSegments& segment);

    /// The significant peak with the most power, of all samples or of one.
    [[nodiscard]] std::optional<WavePeak> wave() const;
    [[nodiscard]] std::optional<WavePeak> wave_of(std::size_t sample) const;

    /// The k with the most power at all frequencies, all samples together.
    [[nodiscard]] std::size_t strongest_mode() const;

    /// Appends `wave_velocity` if there is a wave: standard error by the jackknife over up to 16
    /// groups of samples (a weak peak stands out of all of them, not of one), for a single sample
    /// from the scatter of chi^2 over the peak; systematic error half a frequency step; settings k,
    /// peak_ratio, peak_sigmas. Returns the wave.
    std::optional<WavePeak> append_wave(Results& results) const;

  private:
    /// Power of one mode and direction (0 up, 1 down), k from 0 to M/2, summed over samples
    /// first..last-1.
    [[nodiscard]] std::vector<double> power(std::size_t mode, std::size_t direction,
                                            std::size_t first, std::size_t last) const;
    [[nodiscard]] PeakSearch search(std::size_t mode, std::size_t samples) const;
    [[nodiscard]] std::optional<WavePeak> strongest(std::size_t first, std::size_t last) const;
    [[nodiscard]] double velocity(std::size_t mode, std::size_t direction, double k) const;
    [[nodiscard]] double velocity_error(const WavePeak& wave) const;

    BinnedRecord record_;
    std::size_t points_, segments_ = 0;
    SpeedBand band_;
    std::vector<float> window_;
    PairTransform transform_;
    std::vector<std::complex<float>> phases_;  ///< shape (modes, bins)
    std::vector<float> power_;  ///< sums over segments, shape (samples, modes, 2, M/2 + 1)
};

}  // namespace crossgrain::measure
