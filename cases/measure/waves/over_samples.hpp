// Measurements over the samples of a record (binned_record.hpp) or the replicas of an ensemble.
#pragma once

#include "cases/measure/results.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace crossgrain::measure {

/// Share of the samples for which something holds, with its binomial standard error.
[[nodiscard]] Measurement fraction(const std::string& observable, std::size_t holding,
                                   std::size_t samples);

/// The mean of one value per sample (or group of samples) with its standard error.
[[nodiscard]] Measurement over_samples(const std::string& observable,
                                       std::span<const double> values, const std::string& unit);

}  // namespace crossgrain::measure
