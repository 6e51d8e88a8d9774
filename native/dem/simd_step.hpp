// The steps of the simd kernel, compiled for every instruction set and chosen at run time.
#pragma once

#include "native/dem/simd_format.hpp"

#include <string>

namespace crossgrain::dem {

template <class Format>
struct StepFunctions {
    using Function = void (*)(const StepTask<Format>&);
    GroupShape group;
    std::string instruction_set;
    /// From (x_n, v_n, a_n) to (x_{n+1}, v*, v_{n+1/2}): half a kick and the drift.
    Function open = nullptr;
    /// Forces at n+1, two half kicks, the drift to n+2.
    Function full = nullptr;
    /// Forces at n+1 and half a kick: to (x_{n+1}, v_{n+1}, a_{n+1}).
    Function close = nullptr;
    /// Of the neighbour list.
    void (*order_rows)(const RowOrderTask<Format>&) = nullptr;
    Survey (*survey)(const SurveyTask<Format>&) = nullptr;
};

/// The functions for this law and scheme on this machine.
[[nodiscard]] StepFunctions<MixedFormat> mixed_step_functions(const Parameters& parameters);
[[nodiscard]] StepFunctions<DoubleFormat> double_step_functions(const Parameters& parameters);

}  // namespace crossgrain::dem
