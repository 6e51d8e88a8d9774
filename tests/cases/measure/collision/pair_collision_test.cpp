// Collisions with known free flights on both sides, and scenes that must give no number.
#include "cases/measure/collision/pair_collision.hpp"

#include "tests/cases/measure/synthetic_frame.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

constexpr double d = 2;

/// A collision given by what the estimator must find.
struct Planned {
    double speed = 1;        // before
    double b = 0;            // impact parameter
    double normal_turn = 0;  // angle from n_in to n_out
    double restitution = 0.8;
    double tangential = 1;  // v_t after/before
    double t_in = 0.3, duration = 0.1;
    double direction = 0;  // of the incoming flight
    double centre_vx = 0, centre_vy = 0;
};

struct Vector {
    double x, y;
};
Vector turned(Vector v, double angle) {
    return {v.x * std::cos(angle) - v.y * std::sin(angle),
            v.x * std::sin(angle) + v.y * std::cos(angle)};
}

// Adds grains 2k, 2k+1 at time t (a time of free flight) around (x0, y0). `weight` is the share of
// the relative motion that the second grain makes: 1/2 for equal masses, 1 if the first is frozen.
void add_pair(SyntheticFrame& frame, const Planned& p, double x0, double y0, double weight = 0.5) {
    const double cosine = std::sqrt(1 - p.b * p.b / (d * d));
    const double angle_in = std::atan2(p.b / d, -cosine) + p.direction;
    const double v_n = -p.speed * cosine, v_t = -p.speed * p.b / d;
    Vector r{}, v{};
    if (frame.time < p.t_in + p.duration / 2) {
        v = turned({v_n, v_t}, angle_in);
        r = turned({d, 0}, angle_in);
        r = {r.x + v.x * (frame.time - p.t_in), r.y + v.y * (frame.time - p.t_in)};
    } else {
        const double angle_out = angle_in + p.normal_turn;
        v = turned({-p.restitution * v_n, p.tangential * v_t}, angle_out);
        r = turned({d, 0}, angle_out);
        const double since = frame.time - p.t_in - p.duration;
        r = {r.x + v.x * since, r.y + v.y * since};
    }
    const double cx = x0 + p.centre_vx * frame.time, cy = y0 + p.centre_vy * frame.time;
    const double first = weight - 1;
    frame.add_grain(cx + first * r.x, cy + first * r.y, p.centre_vx + first * v.x,
                    p.centre_vy + first * v.y);
    frame.add_grain(cx + weight * r.x, cy + weight * r.y, p.centre_vx + weight * v.x,
                    p.centre_vy + weight * v.y);
}

measure::Results run(const scene::Scene& scene, const std::vector<SyntheticFrame>& frames) {
    measure::PairCollision estimator(scene);
    for (const auto& frame : frames)
        estimator.add(frame.view());
    measure::Results results;
    estimator.finish(results);
    return results;
}

measure::Results run(const std::vector<Planned>& pairs) {
    std::vector<SyntheticFrame> frames;
    for (const double t : {0.0, 0.1, 1.2}) {
        SyntheticFrame frame{.step = std::lround(t * 1000), .time = t};
        double y = 0;
        for (const Planned& p : pairs)
            add_pair(frame, p, 3.0, y += 10);
        frames.push_back(std::move(frame));
    }
    return run(plain_scene(2 * pairs.size()), frames);
}

// Known to a few roundings of positions of order 30.
const auto roundings = tt::tolerance(1e-12);

}  // namespace

BOOST_AUTO_TEST_CASE(head_on_collisions) {
    const auto results = run({Planned{.restitution = 0.8, .duration = 0.1},
                              Planned{.restitution = 0.6, .t_in = 0.21, .duration = 0.3},
                              Planned{.speed = 3, .restitution = 0.7, .direction = 2}});
    const auto& e = get(results, "restitution");
    BOOST_TEST(e.value == 0.7, roundings);
    BOOST_TEST(e.standard_error == 0.1 / std::sqrt(3.0), roundings);
    BOOST_TEST(e.n == 3U);
    BOOST_TEST(get(results, "contact_time").value == 0.5 / 3, roundings);
    BOOST_TEST(get(results, "contact_time").unit == "t");
    BOOST_TEST(get(results, "complete_collisions").value == 3);
    BOOST_TEST(!find(results, "angular_momentum_ratio"));  // 0/0
    BOOST_TEST(column(results, "collisions", "restitution")[1] == 0.6, roundings);
    BOOST_TEST(column(results, "collisions", "approach_speed")[2] == 3.0, roundings);
}

BOOST_AUTO_TEST_CASE(oblique_collision_uses_both_normals) {
    const Planned p{.speed = 2,
                    .b = 1.2,
                    .normal_turn = -0.17,
                    .restitution = 0.75,
                    .tangential = 0.6,
                    .direction = 0.9,
                    .centre_vx = 0.3,
                    .centre_vy = -0.2};
    const auto results = run({p});
    BOOST_TEST(get(results, "restitution").value == 0.75, roundings);
    BOOST_TEST(get(results, "restitution").standard_error == 0);
    BOOST_TEST(get(results, "contact_time").value == 0.1, roundings);
    // r x v = d v_t at contact.
    BOOST_TEST(get(results, "angular_momentum_ratio").value == 0.6, roundings);
    BOOST_TEST(get(results, "speed_ratio").value ==
                   std::hypot(0.75 * std::sqrt(1 - 0.36), 0.6 * 0.6),
               roundings);
    BOOST_TEST(column(results, "collisions", "impact_parameter")[0] == 0.6, roundings);
}

BOOST_AUTO_TEST_CASE(grains_of_unequal_size_touch_at_their_own_distance) {
    const Planned p{.b = 0.5, .restitution = 0.75, .tangential = 0.6};
    std::vector<SyntheticFrame> frames;
    for (const double t : {0.0, 1.2}) {
        SyntheticFrame frame{.time = t};
        add_pair(frame, p, 0, 0);
        frames.push_back(std::move(frame));
    }
    auto scene = plain_scene(2);
    scene.grains.diameter = 1;
    scene.grains.diameters = {1, 3};  // d on average
    scene.grains.masses = {1, 27};
    BOOST_TEST(get(run(scene, frames), "restitution").value == 0.75, roundings);
    BOOST_TEST(get(run(scene, frames), "contact_time").value == 0.1, roundings);
    // Grains that touch elsewhere are not these.
    scene.grains.diameters = {1, 1};
    BOOST_TEST(find(run(scene, frames), "restitution") == nullptr);
}

BOOST_AUTO_TEST_CASE(frozen_partner) {
    auto scene = plain_scene(2);
    scene.initial.frozen = {true, false};
    std::vector<SyntheticFrame> frames;
    for (const double t : {0.0, 1.2}) {
        SyntheticFrame frame{.time = t};
        add_pair(frame, {.b = 0.5}, 0, 0, 1.0);
        BOOST_TEST(frame.vx[0] == 0);
        frames.push_back(std::move(frame));
    }
    BOOST_TEST(get(run(scene, frames), "restitution").value == 0.8, roundings);
}

BOOST_AUTO_TEST_CASE(pair_across_the_period_may_fly_further_than_half_of_it) {
    auto scene = plain_scene(2);
    scene.periodic_x = 6;
    scene.periodic_y = 5;
    std::vector<SyntheticFrame> frames;
    for (const double t : {0.0, 5.0}) {  // apart by 2 + 0.8*4.6 = 5.7 > 3 at the end
        SyntheticFrame frame{.time = t};
        add_pair(frame, {}, 0, 0);
        frame.x[1] += 6;
        frame.y[0] -= 10;
        frames.push_back(std::move(frame));
    }
    const auto results = run(scene, frames);
    BOOST_TEST(get(results, "restitution").value == 0.8, roundings);
    BOOST_TEST(get(results, "contact_time").value == 0.1, tt::tolerance(1e-11));
}

BOOST_AUTO_TEST_CASE(exact_motion_through_a_contact) {
    // Relative motion of a head-on collision in closed form, sampled anywhere:
    // overlap = (v/omega) exp(-gamma t) sin(omega t), e = exp(-gamma pi/omega).
    const double gamma = 2.2314355131420975, omega = std::acos(-1.0) / 0.1, v = 1.7, t_in = 0.0371;
    std::vector<SyntheticFrame> frames;
    for (int i = 0; i <= 40; ++i) {
        const double t = 0.01 * i, s = t - t_in;
        double r = d - v * s, rate = -v;
        if (s > 0.1) {
            rate = 0.8 * v;
            r = d + rate * (s - 0.1);
        } else if (s > 0) {
            const double decay = v / omega * std::exp(-gamma * s);
            r = d - decay * std::sin(omega * s);
            rate = -decay * (omega * std::cos(omega * s) - gamma * std::sin(omega * s));
        }
        SyntheticFrame frame{.step = i, .time = t};
        frame.add_grain(-r / 2, 0, -rate / 2, 0);
        frame.add_grain(r / 2, 0, rate / 2, 0);
        frames.push_back(std::move(frame));
    }
    const auto results = run(plain_scene(2), frames);
    BOOST_TEST(get(results, "restitution").value == 0.8, roundings);
    BOOST_TEST(get(results, "contact_time").value == 0.1, roundings);
}

BOOST_AUTO_TEST_CASE(one_incomplete_pair_withholds_the_mean) {
    const Planned good{};
    for (const Planned& bad : {Planned{.t_in = 1.1, .duration = 0.3},  // still touching
                               Planned{.t_in = 5},                     // not yet touching
                               Planned{.t_in = -0.05},                 // touching at the start
                               Planned{.normal_turn = 3.14159265358979}}) {  // passed through
        const auto results = run({good, bad});
        BOOST_TEST(get(results, "complete_collisions").value == 1);
        BOOST_TEST(get(results, "complete_collisions").n == 2U);
        BOOST_TEST(results.measurements.size() == 1U);
        BOOST_TEST(results.series.empty());
    }
}

BOOST_AUTO_TEST_CASE(grazing_flight_without_force_is_no_collision) {
    // Straight through the rim of the other grain: turned normal, unchanged velocity.
    std::vector<SyntheticFrame> frames;
    for (const double t : {0.0, 4.0}) {
        SyntheticFrame frame{.time = t};
        frame.add_grain(0, 0, 0, 0);
        frame.add_grain(-2 + t, 1.9, 1, 0);
        frames.push_back(std::move(frame));
    }
    BOOST_TEST(get(run(plain_scene(2), frames), "complete_collisions").value == 0);
}

BOOST_AUTO_TEST_CASE(a_miss_is_no_collision) {
    std::vector<SyntheticFrame> frames;
    for (const double t : {0.0, 6.0}) {
        SyntheticFrame frame{.time = t};
        frame.add_grain(0, 0, 0, 0);
        frame.add_grain(-3 + t, 2.1, 1, 0);
        frames.push_back(std::move(frame));
    }
    BOOST_TEST(get(run(plain_scene(2), frames), "complete_collisions").value == 0);
}

BOOST_AUTO_TEST_CASE(scenes_that_are_not_isolated_pairs_give_nothing) {
    std::vector<SyntheticFrame> frames;
    for (const double t : {0.0, 1.2}) {
        SyntheticFrame frame{.time = t};
        add_pair(frame, {}, 0, 0);
        frames.push_back(std::move(frame));
    }
    auto falling = plain_scene(2);
    falling.gravity = 1;
    BOOST_TEST(run(falling, frames).measurements.empty());
    auto boxed = plain_scene(2);
    boxed.plates.bottom = scene::PrescribedPlate{};
    BOOST_TEST(run(boxed, frames).measurements.empty());
    BOOST_TEST(run(plain_scene(3), frames).measurements.empty());
    BOOST_TEST(run(plain_scene(0), {}).measurements.empty());
    BOOST_TEST(run(plain_scene(2), {}).measurements.empty());
    BOOST_TEST(get(run(plain_scene(2), {frames[0]}), "complete_collisions").value == 0);
}
