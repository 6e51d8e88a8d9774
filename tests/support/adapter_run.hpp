// Running a code in a test, in a directory of its own.
#pragma once

#include "adapters/code.hpp"
#include "cases/scene/frame.hpp"
#include "cases/scene/scene.hpp"
#include "tests/support/kept_frames.hpp"
#include "tests/support/temporary_directory.hpp"

#include <vector>

namespace crossgrain::tests {

/// All frames of a run in a directory of its own. Throws what the code throws.
inline std::vector<KeptFrame> frames_of(const adapters::GrainCode& code, const scene::Scene& scene,
                                        double time_limit = 60) {
    const TemporaryDirectory directory;
    std::vector<KeptFrame> frames;
    code.run(scene, {.directory = directory.path(), .time_limit = time_limit, .stop = {}},
             [&](const scene::Frame& frame) { frames.emplace_back(frame); });
    return frames;
}

}  // namespace crossgrain::tests
