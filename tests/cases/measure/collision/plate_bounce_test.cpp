// Bounces in closed form on plates at rest and on a free lid, and scenes that must give no number.
#include "cases/measure/collision/plate_bounce.hpp"

#include "tests/cases/measure/synthetic_frame.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

constexpr double k = 496;

// Gap and its rate at time t for a harmonic contact of duration pi sqrt(mu/k) from t_in on.
struct Gap {
    double value, rate;
};
Gap harmonic_gap(double t, double t_in, double speed, double mu) {
    const double omega = std::sqrt(k / mu), duration = std::numbers::pi / omega, s = t - t_in;
    if (s <= 0) return {-speed * s, -speed};
    if (s >= duration) return {speed * (s - duration), speed};
    return {-speed / omega * std::sin(omega * s), -speed * std::cos(omega * s)};
}

measure::Results run(const scene::Scene& scene, const std::vector<SyntheticFrame>& frames) {
    measure::PlateBounce estimator(scene);
    for (const auto& frame : frames)
        estimator.add(frame.view());
    measure::Results results;
    estimator.finish(results);
    return results;
}

scene::Scene scene_with_bottom(scene::PlateContact touches, std::size_t grains) {
    auto scene = plain_scene(grains);
    scene.plates = {.stiffness = k,
                    .touches = touches,
                    .bottom = scene::PrescribedPlate{.height = -0.3},
                    .lid = {}};
    return scene;
}

// Grains of different speeds above a bottom at -0.3.
std::vector<SyntheticFrame> bounces_on_bottom(double reach, double t_last) {
    std::vector<SyntheticFrame> frames;
    for (const double t : {0.0, 0.2, t_last}) {
        SyntheticFrame frame{.time = t};
        for (int i = 0; i < 3; ++i) {
            const Gap gap = harmonic_gap(t, 0.1 + 0.013 * i, 1.0 + i, 1.0);
            frame.add_grain(10.0 * i, -0.3 + reach + gap.value, 0.2, gap.rate);
        }
        frames.push_back(std::move(frame));
    }
    return frames;
}

}  // namespace

BOOST_AUTO_TEST_CASE(bounce_on_a_bottom_at_rest) {
    for (const auto touches : {scene::PlateContact::centre, scene::PlateContact::surface}) {
        const double reach = touches == scene::PlateContact::surface ? 1 : 0;
        const auto results = run(scene_with_bottom(touches, 3), bounces_on_bottom(reach, 1.0));
        // A few roundings.
        BOOST_TEST(get(results, "plate_restitution").value == 1.0, tt::tolerance(1e-13));
        BOOST_TEST(get(results, "plate_contact_time").value == std::numbers::pi / std::sqrt(k),
                   tt::tolerance(1e-13));
        BOOST_TEST(get(results, "plate_contact_time").n == 3U);
        BOOST_TEST(!find(results, "plate_momentum_error"));
    }
}

BOOST_AUTO_TEST_CASE(wrong_reach_gives_no_bounce) {
    // A code that touches surfaces, read as one that touches centres.
    const auto results =
        run(scene_with_bottom(scene::PlateContact::centre, 3), bounces_on_bottom(1.0, 3.0));
    // Departure would come before arrival.
    BOOST_TEST(get(results, "complete_bounces").value == 0);
    BOOST_TEST(results.measurements.size() == 1U);
}

BOOST_AUTO_TEST_CASE(bounce_on_a_free_lid) {
    const double M = 0.1, mu = M / (1 + M), v = 1.2, V = -0.4;
    auto scene = plain_scene(1);
    scene.plates = {.stiffness = k, .touches = {}, .bottom = {}, .lid = scene::FreeLid{.mass = M}};
    std::vector<SyntheticFrame> frames;
    for (const double t : {0.0, 0.3, 1.0}) {
        const Gap gap = harmonic_gap(t, 0.2, v - V, mu);
        const double centre_speed = (v + M * V) / (1 + M);
        // gap = h - y about the centre of mass.
        SyntheticFrame frame{.time = t};
        frame.add_grain(0, centre_speed * t - M / (1 + M) * gap.value, 0,
                        centre_speed - M / (1 + M) * gap.rate);
        frame.lid = scene::LidState{centre_speed * t + gap.value / (1 + M),
                                    centre_speed + gap.rate / (1 + M)};
        frames.push_back(std::move(frame));
    }
    auto results = run(scene, frames);
    BOOST_TEST(get(results, "plate_restitution").value == 1.0, tt::tolerance(1e-13));
    BOOST_TEST(get(results, "plate_contact_time").value == std::numbers::pi * std::sqrt(mu / k),
               tt::tolerance(1e-12));
    BOOST_TEST(std::abs(get(results, "plate_momentum_error").value) < 1e-13);

    // A lid that loses a hundredth of its velocity.
    frames.back().lid->velocity *= 0.99;
    results = run(scene, frames);
    BOOST_TEST(std::abs(get(results, "plate_momentum_error").value) > 0.01);
    BOOST_TEST(std::abs(get(results, "plate_restitution").value - 1) > 0.01);

    // Two grains under one lid: its flight between them is not free.
    auto crowded = scene;
    crowded.initial.x = crowded.initial.y = crowded.initial.vx = crowded.initial.vy = {0, 0};
    for (auto& frame : frames)
        frame.add_grain(9, frame.y[0], 0, frame.vy[0]);
    BOOST_TEST(run(crowded, frames).measurements.empty());
}

BOOST_AUTO_TEST_CASE(lid_at_rest_is_met_by_grains_that_fly_up) {
    auto scene = scene_with_bottom(scene::PlateContact::surface, 2);
    scene.plates.lid = scene::PrescribedPlate{.height = 5};
    std::vector<SyntheticFrame> frames;
    for (const double t : {0.0, 1.0}) {
        const Gap low = harmonic_gap(t, 0.1, 1, 1), high = harmonic_gap(t, 0.4, 2, 1);
        SyntheticFrame frame{.time = t};
        frame.add_grain(0, -0.3 + 1 + low.value, 0, low.rate);
        frame.add_grain(9, 5 - 1 - high.value, 0, -high.rate);
        frames.push_back(std::move(frame));
    }
    const auto results = run(scene, frames);
    BOOST_TEST(get(results, "complete_bounces").value == 2);
    BOOST_TEST(get(results, "plate_contact_time").value == std::numbers::pi / std::sqrt(k),
               tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(unfinished_bounces_withhold_the_mean) {
    const auto scene = scene_with_bottom(scene::PlateContact::centre, 3);
    const auto results = run(scene, bounces_on_bottom(0, 0.25));
    BOOST_TEST(get(results, "complete_bounces").value < 3);
    BOOST_TEST(results.measurements.size() == 1U);
}

BOOST_AUTO_TEST_CASE(scenes_without_a_free_bounce_give_nothing) {
    const auto frames = bounces_on_bottom(0, 1.0);
    const auto good = scene_with_bottom(scene::PlateContact::centre, 3);
    auto bad = good;
    bad.gravity = 1;
    BOOST_TEST(run(bad, frames).measurements.empty());
    bad = good;
    bad.plates.bottom->amplitude = 0.1;
    BOOST_TEST(run(bad, frames).measurements.empty());
    bad = good;
    bad.plates.bottom.reset();
    BOOST_TEST(run(bad, frames).measurements.empty());
    bad = good;
    bad.initial.frozen = {false, true, false};
    BOOST_TEST(run(bad, frames).measurements.empty());
    BOOST_TEST(run(good, {}).measurements.empty());
}
