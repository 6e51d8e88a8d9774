// What computes the steps, behind the public Engine: the scalar kernel or the simd kernel.
#pragma once

#include "native/friction/engine.hpp"

#include <cstdint>
#include <memory>

namespace crossgrain::friction {

class StepKernel {
  public:
    virtual ~StepKernel() = default;

    /// As Engine::advance.
    virtual void advance(std::int64_t steps) = 0;
    /// As Engine::state; a kernel with a memory layout of its own makes it when asked.
    [[nodiscard]] virtual const State& state() = 0;
    [[nodiscard]] virtual Effort effort() const = 0;
};

/// The one that Parameters::kernel asks for, or the one that suits the system best.
/// Throws as Engine::Engine.
[[nodiscard]] std::unique_ptr<StepKernel> make_kernel(const Parameters& parameters, State state);

/// Rounds identically on every machine.
[[nodiscard]] std::unique_ptr<StepKernel> make_scalar_kernel(const Parameters& parameters,
                                                             State state);

/// Same physics, other rounding. Only where simd_lanes() is not 0.
[[nodiscard]] std::unique_ptr<StepKernel> make_simd_kernel(const Parameters& parameters,
                                                           State state);

}  // namespace crossgrain::friction
