// The record of a lattice gas as the estimators of waves read it (waves/binned_record.hpp).
#pragma once

#include "cases/measure/waves/binned_record.hpp"
#include "cases/scene/gas_sampling.hpp"

namespace crossgrain::measure {

/// Every replica is a sample; GasFrame::count is a field.
[[nodiscard]] inline BinnedRecord gas_record(const scene::GasSampling& sampling) {
    return {.shape = {static_cast<std::size_t>(sampling.bins()),
                      static_cast<std::size_t>(sampling.replicas)},
            .length = static_cast<double>(sampling.length),
            .interval = static_cast<double>(sampling.every),
            .length_unit = "sites",
            .time_unit = "steps",
            .velocity_unit = "sites/step"};
}

}  // namespace crossgrain::measure
