// What the tests of codes with friction share: a run held against the reference integrator in the
// conventions of that code, and a run whose input has been tampered with.
#pragma once

#include "adapters/code.hpp"
#include "tests/support/adapter_run.hpp"
#include "tests/support/frictional_scenes.hpp"
#include "tests/support/kept_frames.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace crossgrain::tests {

/// Largest difference between the code's run and the reference; infinite if it refuses the scene.
inline double friction_difference(const adapters::GrainCode& code, const scene::Scene& scene,
                                  const scene::FrictionConventions& conventions,
                                  Coordinates coordinates = Coordinates::unwrapped) {
    const auto refusal = code.cannot_express(scene);
    BOOST_TEST(!refusal.has_value(), scene.name << ": " << refusal.value_or(""));
    if (refusal) return std::numeric_limits<double>::infinity();
    const double found = largest_difference(frames_of(code, scene),
                                            reference_frames(scene, conventions, coordinates));
    BOOST_TEST_MESSAGE(code.name() << ", " << scene.name << ": " << found);
    return found;
}

/// The same for grains that differ, with drag, backing planes and dashpots per effective mass, but
/// without friction: for the reference, friction with the coefficient 0.
inline double frictionless_difference(const adapters::GrainCode& code,
                                      const scene::FrictionConventions& conventions,
                                      Coordinates coordinates) {
    auto scene = pipe_in_small(frictional_law());
    scene.contact.damping_scale = scene::DampingScale::effective_mass;
    scene.contact.friction->coefficient = 0;
    auto reference = reference_frames(scene, conventions, coordinates);
    for (auto& frame : reference)
        frame.omega.clear();
    scene.contact.friction.reset();
    BOOST_TEST(!code.cannot_express(scene).has_value());
    const double found = largest_difference(frames_of(code, scene), reference);
    BOOST_TEST_MESSAGE(code.name() << ", without friction: " << found);
    return found;
}

/// A text of the code's generated input that is replaced by another before the run.
struct Edit {
    std::string file, from, to;
};

/// All frames of a run with the edited input. The text must be there.
inline std::vector<KeptFrame> frames_of_edited(const adapters::GrainCode& code,
                                               const scene::Scene& scene, const Edit& edit) {
    auto input = code.input(scene);
    const auto file = std::find_if(input.begin(), input.end(), [&](const auto& candidate) {
        return candidate.name == edit.file;
    });
    BOOST_TEST_REQUIRE((file != input.end()), "no input file " << edit.file);
    const std::size_t at = file->text.find(edit.from);
    BOOST_TEST_REQUIRE(at != std::string::npos, edit.file << " does not hold " << edit.from);
    file->text.replace(at, edit.from.size(), edit.to);
    const TemporaryDirectory directory;
    std::vector<KeptFrame> frames;
    code.run(
        scene,
        {.directory = directory.path(), .time_limit = 60, .stop = {}, .input = std::move(input)},
        [&](const scene::Frame& frame) { frames.emplace_back(frame); });
    return frames;
}

/// The text of one file of the code's input.
inline std::string input_text(const adapters::GrainCode& code, const scene::Scene& scene,
                              const std::string& name) {
    for (const auto& file : code.input(scene)) {
        if (file.name == name) return file.text;
    }
    return {};
}

inline bool refuses(const adapters::GrainCode& code, const scene::Scene& scene,
                    const std::string& because) {
    const auto reason = code.cannot_express(scene);
    return reason && reason->find(because) != std::string::npos;
}

}  // namespace crossgrain::tests
