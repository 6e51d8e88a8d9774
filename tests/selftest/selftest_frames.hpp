// What can go wrong with frames between a code and the estimators, planted on purpose. A filter is
// made for one run and passes frames on, spoiled.
#pragma once

#include "cases/scene/any_scene.hpp"

#include <functional>
#include <string>
#include <vector>

namespace crossgrain::selftest {

template <class FrameT>
using FrameSinkOf = std::function<void(const FrameT&)>;

/// Names of the filters, for messages and documentation.
///
/// Grains: "nan-in-one-frame", "duplicated-frame", "lost-frame", "truncated", "wrapped-positions"
/// (folded into the periodic box), "swapped-axes", "half-step-velocities" (mean of this frame's and
/// the one before), "late-positions" (of the frame before), "single-precision", "reversed-grains",
/// "lid-off-by-radius".
/// Lattice gas and signals: "duplicated-frame", "lost-frame", "truncated", "late-bins" (half of
/// the bins are a frame late), "mirrored-bins", "repeated-replica" (all but one replica are
/// copies), "lost-rests" (particles at rest not counted), "doubled-replicas" (each replica twice).
/// Hopper: "lost-frame", "truncated", "late-flow" (without the last iteration), "mirrored-state",
/// "hidden-orientation" (all grains of orientation 1), "lost-grain".
/// All throw CaseError, naming `place`, for a name that is not among them.
[[nodiscard]] FrameSinkOf<scene::Frame> frame_filter(const std::string& name,
                                                     const scene::Scene& scene,
                                                     FrameSinkOf<scene::Frame> next,
                                                     const std::string& place);
[[nodiscard]] FrameSinkOf<scene::GasFrame> frame_filter(const std::string& name,
                                                        const scene::GasSampling& sampling,
                                                        FrameSinkOf<scene::GasFrame> next,
                                                        const std::string& place);
[[nodiscard]] FrameSinkOf<scene::HopperFrame> frame_filter(const std::string& name,
                                                           const scene::HopperAutomaton& scene,
                                                           FrameSinkOf<scene::HopperFrame> next,
                                                           const std::string& place);

/// In one call for all models of the same frames.
[[nodiscard]] inline FrameSinkOf<scene::GasFrame> frame_filter(const std::string& name,
                                                               const scene::LatticeGas& scene,
                                                               FrameSinkOf<scene::GasFrame> next,
                                                               const std::string& place) {
    return frame_filter(name, scene.sampling, std::move(next), place);
}
[[nodiscard]] inline FrameSinkOf<scene::GasFrame> frame_filter(const std::string& name,
                                                               const scene::SyntheticSignal& scene,
                                                               FrameSinkOf<scene::GasFrame> next,
                                                               const std::string& place) {
    return frame_filter(name, scene.sampling, std::move(next), place);
}

}  // namespace crossgrain::selftest
