// A code against the reference integrator, with the largest difference in the message.
#pragma once

#include "adapters/code.hpp"
#include "tests/support/adapter_run.hpp"
#include "tests/support/kept_frames.hpp"
#include "tests/support/reference_dem.hpp"

#include <boost/test/unit_test.hpp>

#include <vector>

namespace crossgrain::tests {

/// Round-off grows a few digits in these short scenes; a wrong factor or a step too early is seen
/// at 1e-4 or more.
inline constexpr double parity_limit = 1e-11;

/// Runs the scene and holds it against the reference; returns the code's frames.
inline std::vector<KeptFrame> check_parity(const adapters::GrainCode& code,
                                           const scene::Scene& scene, double limit = parity_limit) {
    std::vector<KeptFrame> frames;
    BOOST_TEST_CONTEXT(code.name() << ", " << scene.name) {
        BOOST_TEST(!code.cannot_express(scene).has_value());
        frames = frames_of(code, scene);
        const double difference = largest_difference(frames, reference_frames(scene));
        BOOST_TEST_MESSAGE("largest difference: " << difference);
        BOOST_TEST(difference < limit);
    }
    return frames;
}

/// The same scene with another contact law.
inline scene::Scene with_law(scene::Scene scene, scene::Damping damping, scene::Clipping clipping) {
    scene.contact.damping_acts_on = damping;
    scene.contact.clipping = clipping;
    scene.name += "/" + to_string(damping) + "/" + to_string(clipping);
    return scene;
}

/// Duration of an elastic contact of a body at constant speed before and after, from where it is at
/// `time`: it touched at `entry`, and is now at `distance` from where it touched.
inline double contact_duration(double time, double entry, double distance, double speed) {
    return time - entry - distance / speed;
}

}  // namespace crossgrain::tests
