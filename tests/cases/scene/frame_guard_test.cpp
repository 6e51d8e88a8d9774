// No trajectory that cannot be what the scene asked for is ever measured.
#include "cases/scene/frame_guard.hpp"
#include "native/base/errors.hpp"
#include "tests/support/kept_frames.hpp"
#include "tests/support/scenes.hpp"

#include <boost/test/unit_test.hpp>

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

using namespace crossgrain;
using scene::FrameGuard;
using tests::KeptFrame;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Three frames, at 0, 10 and 20.
scene::Scene scene_of_three(bool with_lid = false) {
    auto s = with_lid ? tests::free_lid_collision() : tests::head_on_pair();
    s.frame_every = 10;
    s.steps = 20;
    return s;
}

KeptFrame frame_at(const scene::Scene& s, std::int64_t step) {
    scene::Frame frame{.step = step,
                       .time = static_cast<double>(step) * s.dt,
                       .x = s.initial.x,
                       .y = s.initial.y,
                       .vx = s.initial.vx,
                       .vy = s.initial.vy,
                       .lid = {}};
    if (s.has_free_lid()) frame.lid = scene::LidState{.height = 2, .velocity = 0};
    KeptFrame moved(frame);
    for (std::size_t i = 0; i < moved.x.size(); ++i) {
        moved.x[i] += moved.vx[i] * frame.time;
        moved.y[i] += moved.vy[i] * frame.time;
    }
    return moved;
}

/// What the guard says to a trajectory of frames at these steps, the last one spoilt.
std::string answer(const scene::Scene& s, const std::vector<std::int64_t>& steps,
                   const std::function<void(KeptFrame&)>& spoil = {}, bool finish = false) {
    FrameGuard guard(s, [](const auto&) {});
    try {
        for (std::size_t i = 0; i < steps.size(); ++i) {
            auto frame = frame_at(s, steps[i]);
            if (spoil && i + 1 == steps.size()) spoil(frame);
            guard(frame.view());
        }
        if (finish) guard.finish();
    } catch (const TrajectoryError& error) {
        const std::string line = error.what();
        BOOST_TEST(line.find('\n') == std::string::npos);
        return line;
    }
    return "passed";
}

bool says(const std::string& answer, const std::string& words) {
    return answer.find(words) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_complete_trajectory_passes_frame_by_frame) {
    for (const bool lid : {false, true}) {
        const auto s = scene_of_three(lid);
        std::vector<std::int64_t> seen;
        FrameGuard guard(s, [&](const scene::Frame& frame) { seen.push_back(frame.step); });
        for (const std::int64_t step : {0, 10, 20})
            guard(frame_at(s, step).view());
        BOOST_CHECK_NO_THROW(guard.finish());
        BOOST_TEST(seen == (std::vector<std::int64_t>{0, 10, 20}),
                   boost::test_tools::per_element());
        BOOST_TEST(guard.frames_passed() == 3);
    }
}

BOOST_AUTO_TEST_CASE(a_refused_frame_is_not_passed_on) {
    const auto s = scene_of_three();
    int passed = 0;
    FrameGuard guard(s, [&](const auto&) { ++passed; });
    BOOST_CHECK_THROW(guard(frame_at(s, 10).view()), TrajectoryError);
    BOOST_TEST(passed == 0);
    BOOST_TEST(guard.frames_passed() == 0);
}

BOOST_AUTO_TEST_CASE(overlapping_frames_are_refused) {
    const auto s = scene_of_three();
    BOOST_TEST(says(answer(s, {0, 10, 10}), "frame at step 10 comes after the frame at step 10"));
    BOOST_TEST(says(answer(s, {0, 10, 0}), "frames overlap"));
    BOOST_TEST(says(answer(s, {0, 0}), "frames overlap"));
    BOOST_TEST(says(answer(s, {-10}), "frame at step -10"));
}

BOOST_AUTO_TEST_CASE(frames_of_another_schedule_are_told_from_overlaps) {
    const auto s = scene_of_three();
    BOOST_TEST(says(answer(s, {0, 5}), "frame at step 5 lies between steps 0 and 10"));
    BOOST_TEST(says(answer(s, {-100}), "frame at step -100 comes before step 0"));
}

BOOST_AUTO_TEST_CASE(a_missing_frame_is_refused) {
    const auto s = scene_of_three();
    BOOST_TEST(says(answer(s, {0, 20}), "frame at step 10 is missing (found step 20 instead)"));
    BOOST_TEST(says(answer(s, {10}), "frame at step 0 is missing"));
    BOOST_TEST(says(answer(s, {0, 5}), "step 5"));
    BOOST_TEST(says(answer(s, {0, 11}), "frame at step 10 is missing"));
}

BOOST_AUTO_TEST_CASE(a_frame_beyond_the_last_step_is_refused) {
    BOOST_TEST(says(answer(scene_of_three(), {0, 10, 20, 30}), "beyond the last step 20"));
    BOOST_TEST(says(answer(scene_of_three(), {0, 10, 20, 21}), "beyond the last step 20"));
}

BOOST_AUTO_TEST_CASE(a_trajectory_that_ends_early_is_refused) {
    const auto s = scene_of_three();
    BOOST_TEST(answer(s, {0, 10}, {}, true) == "trajectory ends before step 20 (2 of 3 frames)");
    BOOST_TEST(answer(s, {}, {}, true) == "trajectory ends before step 0 (0 of 3 frames)");
}

BOOST_AUTO_TEST_CASE(a_wrong_number_of_grains_is_refused) {
    const auto s = scene_of_three();
    const std::vector<std::vector<double> KeptFrame::*> arrays{&KeptFrame::x, &KeptFrame::y,
                                                               &KeptFrame::vx, &KeptFrame::vy};
    for (const auto array : arrays) {
        BOOST_TEST(
            says(answer(s, {0, 10}, [&](auto& f) { (f.*array).pop_back(); }), "the scene has 2"));
        BOOST_TEST(
            says(answer(s, {0, 10}, [&](auto& f) { (f.*array).push_back(0); }), "the scene has 2"));
    }
}

BOOST_AUTO_TEST_CASE(a_missing_or_extra_lid_is_refused) {
    BOOST_TEST(says(answer(scene_of_three(true), {0, 10}, [](auto& f) { f.lid.reset(); }),
                    "lacks a lid, the scene has one"));
    BOOST_TEST(says(answer(scene_of_three(), {0, 10}, [](auto& f) { f.lid.emplace(); }),
                    "has a lid, the scene has none"));
}

BOOST_AUTO_TEST_CASE(numbers_that_are_none_are_refused_with_the_grain) {
    const std::vector<std::vector<double> KeptFrame::*> arrays{&KeptFrame::x, &KeptFrame::y,
                                                               &KeptFrame::vx, &KeptFrame::vy};
    for (const double bad : {not_a_number, infinite, -infinite}) {
        for (const auto array : arrays) {
            BOOST_TEST(
                says(answer(scene_of_three(), {0, 10}, [&](auto& f) { (f.*array)[1] = bad; }),
                     "grain 1 is not finite at step 10"));
        }
        const auto s = scene_of_three(true);
        BOOST_TEST(says(answer(s, {0, 10}, [&](auto& f) { f.lid->height = bad; }), "lid"));
        BOOST_TEST(says(answer(s, {0, 10}, [&](auto& f) { f.lid->velocity = bad; }), "lid"));
    }
}

BOOST_AUTO_TEST_CASE(a_grain_that_moves_a_diameter_per_step_is_refused) {
    const auto s = scene_of_three();
    const double limit = s.grains.diameter / s.dt;
    const auto at_speed = [&](double vx, double vy) {
        return answer(s, {0, 10}, [&](auto& f) { f.vx[1] = vx, f.vy[1] = vy; });
    };
    BOOST_TEST(!says(at_speed(0.999 * limit, 0), "in one time step"));
    BOOST_TEST(says(at_speed(1.001 * limit, 0), "grain 1 moves 1 diameters in one time step"));
    BOOST_TEST(says(at_speed(0, -2 * limit), "dt = 0.0001 is too large"));
    BOOST_TEST(says(at_speed(0.8 * limit, -0.8 * limit), "moves 1.13 diameters"));
}

BOOST_AUTO_TEST_CASE(angular_velocities_are_there_and_finite_where_there_is_friction) {
    auto s = scene_of_three();
    s.contact.friction = scene::Friction{};
    const auto with = [&](std::vector<double> omega) {
        return answer(s, {0}, [&](KeptFrame& frame) { frame.omega = omega; });
    };
    BOOST_TEST(with({1, -2}) == "passed");
    BOOST_TEST(says(with({}), "angular velocities of 0 grains, the scene has 2"));
    BOOST_TEST(says(with({1}), "angular velocities of 1 grains, the scene has 2"));
    BOOST_TEST(says(with({1, not_a_number}), "angular velocity of grain 1 is not finite"));
    BOOST_TEST(says(with({infinite, 0}), "angular velocity of grain 0 is not finite"));
}

BOOST_AUTO_TEST_CASE(a_step_is_measured_by_the_smallest_grain) {
    auto s = scene_of_three();
    s.grains.diameters = {2.0, 0.1};
    s.grains.masses = {1.0, 1.0};
    const auto moving = [&](double diameters) {
        return answer(s, {0}, [&](KeptFrame& frame) { frame.vx[0] = diameters * 0.1 / s.dt; });
    };
    BOOST_TEST(!says(moving(0.9), "in one time step"));
    BOOST_TEST(says(moving(1.1), "grain 0 moves 1.1 diameters in one time step"));
}
