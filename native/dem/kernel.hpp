// What computes the steps, behind the public Engine: the scalar kernel or the simd kernel.
#pragma once

#include "native/dem/engine.hpp"

#include <cstdint>
#include <memory>

namespace crossgrain::dem {

class StepKernel {
  public:
    virtual ~StepKernel() = default;

    /// As Engine::advance.
    virtual void advance(std::int64_t steps) = 0;
    /// As Engine::state; a kernel with a memory layout of its own makes it when asked.
    [[nodiscard]] virtual const State& state() = 0;
    [[nodiscard]] virtual MissedContacts missed_contacts() const = 0;
    [[nodiscard]] virtual Effort effort() const = 0;
};

/// The one that Parameters::kernel asks for, or the one that suits the system best.
/// Throws std::invalid_argument when it asks for what the system does not allow.
[[nodiscard]] std::unique_ptr<StepKernel> make_kernel(const Parameters& parameters, State state);

/// Any law, scheme and contacts; rounds identically on every machine.
[[nodiscard]] std::unique_ptr<StepKernel> make_scalar_kernel(const Parameters& parameters,
                                                             State state);

/// Only what why_not_simd() has nothing against; the faster the more grains there are.
[[nodiscard]] std::unique_ptr<StepKernel> make_simd_kernel(const Parameters& parameters,
                                                           State state);

}  // namespace crossgrain::dem
