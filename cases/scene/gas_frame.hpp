// One instant of an ensemble of lattice gases, as estimators see it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace crossgrain::scene {

/// Views are valid during the call only. Fields have shape (bins, replicas), the replica index
/// running fastest; a field the scene does not ask for is empty.
struct GasFrame {
    std::int64_t step = 0;  ///< time steps since the start of the run, burn-in included
    std::size_t bins = 0;
    std::size_t replicas = 0;
    std::span<const std::uint16_t> count;    ///< particles in the bin, walls included
    std::span<const std::uint16_t> rests;    ///< of these, at rest
    std::span<const std::int16_t> momentum;  ///< sum of downward velocities, unit 1/2 site per step
    /// Particles at rest exceeded the free sites during this step: the last frame of the run, only
    /// with OnSaturation::record; which replicas, shape (replicas), 0 or 1. Empty otherwise.
    std::span<const std::uint8_t> saturated;
};

}  // namespace crossgrain::scene
