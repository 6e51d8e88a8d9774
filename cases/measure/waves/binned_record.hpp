// What the estimators of density waves read, whatever the model: the numbers of particles in equal
// bins along a pipe at equal intervals of time, of several samples at once. A sample is a replica
// of an ensemble, or a block of one run: errors are the scatter of samples. Bins are counted along
// gravity, so that what falls moves towards larger indices.
#pragma once

#include <cstddef>
#include <string>

namespace crossgrain::measure {

/// Fields have shape (bins, samples), the sample index running fastest.
struct FieldShape {
    std::size_t bins = 0;
    std::size_t samples = 0;
    [[nodiscard]] std::size_t size() const noexcept { return bins * samples; }
};

struct BinnedRecord {
    FieldShape shape;
    double length = 0;    ///< L of the pipe, > 0, in the model's unit of length
    double interval = 0;  ///< T between two fields, > 0, in its unit of time
    std::string length_unit = "l", time_unit = "t", velocity_unit = "l/t";

    [[nodiscard]] double bin() const { return length / static_cast<double>(shape.bins); }
};

}  // namespace crossgrain::measure
