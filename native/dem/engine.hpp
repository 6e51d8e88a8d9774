// Distinct elements in two dimensions: advances a State by whole time steps.
// Which kernel does it is decided once, by native/dem/kernel_choice.cpp; what a step consists of is
// written in native/dem/scheme_*.hpp.
#pragma once

#include "native/dem/system.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace crossgrain::dem {

/// Overlaps of grains that are no fixed neighbours (Contacts::lattice_neighbours): rows that slide
/// through each other. Looked for at the end of every step; always none with a neighbour list.
struct MissedContacts {
    std::int64_t pairs = 0;            ///< different pairs that have overlapped so far
    std::optional<double> first_time;  ///< of the first such overlap
};

/// What a run has taken so far.
struct Effort {
    std::string kernel;                  ///< e.g. "scalar", "simd mixed (AVX3)"
    std::int64_t force_evaluations = 0;  ///< of all grains together
    std::int64_t neighbour_builds = 0;
    double skin = 0;       ///< of the neighbour list, as it is now (length)
    double looked_at = 0;  ///< neighbours per grain and step, of the present list, with padding
};

class Engine {
  public:
    /// Resolves kernel, law and scheme once; the step loop holds nothing the scene does not need.
    /// Throws std::invalid_argument when the parameters ask for a kernel or a precision that the
    /// system does not allow, see why_not_simd().
    Engine(const Parameters& parameters, State state);
    ~Engine();
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// Advances by `steps` time steps, >= 0.
    /// Throws TrajectoryError when a position is no longer finite.
    void advance(std::int64_t steps);

    /// The grains in the order in which they were given, at time state().step * dt.
    [[nodiscard]] const State& state() const;
    [[nodiscard]] MissedContacts missed_contacts() const;
    [[nodiscard]] Effort effort() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// What the simd kernel (and with it Precision::mixed) lacks for this system; nothing if it has
/// all.
[[nodiscard]] std::optional<std::string> why_not_simd(const Parameters& parameters,
                                                      const State& state);

}  // namespace crossgrain::dem
