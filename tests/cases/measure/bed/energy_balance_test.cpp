// Energy balance on motions that obey their scene's law, known in closed form or integrated finely
// here, and on motions that do not.
#include "tests/cases/measure/energy_run.hpp"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;
using scene::Clipping;
using scene::Damping;

namespace {

/// Oblique collision of two unit masses under any variant of the law: classical Runge-Kutta in
/// steps of `interval`/20 (error far below that of the sampling), a frame every 20 steps. Touches
/// at t = `start`.
std::vector<SyntheticFrame> oblique(const scene::ContactLaw& law, double interval, double start) {
    using State = std::array<double, 4>;  // relative position and velocity
    const auto rate = [&](const State& s) -> State {
        const double r = std::hypot(s[0], s[1]);
        if (r >= d) return {s[2], s[3], 0, 0};
        const double nx = s[0] / r, ny = s[1] / r, v_n = s[2] * nx + s[3] * ny;
        double normal = law.stiffness * (d - r) - law.damping * v_n;
        double drag = law.damping_acts_on == Damping::full_vector ? law.damping : 0.0;
        if (normal < 0 && law.clipping != Clipping::none) {
            normal = 0;
            if (law.clipping == Clipping::all) drag = 0;
        }
        // Reduced mass 1/2.
        return {s[2], s[3], 2 * (normal * nx - drag * (s[2] - v_n * nx)),
                2 * (normal * ny - drag * (s[3] - v_n * ny))};
    };
    const auto moved = [](State s, const State& r, double h) {
        for (std::size_t i = 0; i < 4; ++i)
            s[i] += h * r[i];
        return s;
    };
    State s{-std::sqrt(d * d - 1) - 2 * start, 1, 2, 0};
    std::vector<SyntheticFrame> frames;
    const double h = interval / 20;
    for (int step = 0; step * h < 0.2 + start; ++step) {
        if (step % 20 == 0) {
            SyntheticFrame frame{.step = step / 20, .time = step * h};
            frame.add_grain(-s[0] / 2, -s[1] / 2, -s[2] / 2, -s[3] / 2);
            frame.add_grain(s[0] / 2, s[1] / 2, s[2] / 2, s[3] / 2);
            frames.push_back(std::move(frame));
        }
        const State k1 = rate(s), k2 = rate(moved(s, k1, h / 2)), k3 = rate(moved(s, k2, h / 2)),
                    k4 = rate(moved(s, k3, h));
        for (std::size_t i = 0; i < 4; ++i)
            s[i] += h / 6 * (k1[i] + 2 * (k2[i] + k3[i]) + k4[i]);
    }
    return frames;
}

/// Head-on collision of two unit masses with the attraction kept, in closed form: touches at t_in,
/// parts at t_in + t_col with e = 0.8.
std::vector<SyntheticFrame> head_on(double interval, double t_in, double v) {
    const double gamma = eta, omega = std::numbers::pi / t_col;
    std::vector<SyntheticFrame> frames;
    for (int i = 0; i <= 70; ++i) {
        const double s = i * interval - t_in;
        double r = d - v * s, rate = -v;
        if (s > t_col) {
            rate = 0.8 * v;
            r = d + rate * (s - t_col);
        } else if (s > 0) {
            const double decay = v / omega * std::exp(-gamma * s);
            r = d - decay * std::sin(omega * s);
            rate = -decay * (omega * std::cos(omega * s) - gamma * std::sin(omega * s));
        }
        SyntheticFrame frame{.step = i, .time = i * interval};
        frame.add_grain(0, -r / 2, 0, -rate / 2);
        frame.add_grain(0, r / 2, 0, rate / 2);
        frames.push_back(std::move(frame));
    }
    return frames;
}

}  // namespace

BOOST_AUTO_TEST_CASE(elastic_bounce_under_gravity_keeps_its_energy) {
    // On a plate at rest: free fall from y = 0.1, then y'' = -g - k y below 0, in closed form.
    auto scene = damped_scene(1, t_col / 20);
    scene.gravity = 1;
    scene.plates = {.stiffness = k, .touches = {}, .bottom = scene::PrescribedPlate{}, .lid = {}};
    const double impact = std::sqrt(2 * 0.1), t_in = impact, w = std::sqrt(k);
    std::vector<SyntheticFrame> frames;
    for (int i = 0; i < 101; ++i) {
        const double t = i * t_col / 20, s = t - t_in;
        double y = 0.1 - t * t / 2, v = -t;
        if (s > 0) {
            y = -1 / k + std::cos(w * s) / k - impact / w * std::sin(w * s);
            v = -std::sin(w * s) * w / k - impact * std::cos(w * s);
        }
        if (s > 0 && y > 0) break;
        SyntheticFrame frame{.step = i, .time = t};
        frame.add_grain(0, y, 0.3, v);
        frames.push_back(std::move(frame));
    }
    BOOST_TEST_REQUIRE(frames.size() > 100U);
    const auto results = run(scene, frames);
    // Nothing goes in or out: the residual is the round-off of the energies.
    BOOST_TEST(std::abs(get(results, "energy_residual").value) < 1e-13);
    BOOST_TEST(get(results, "energy_residual").systematic < 1e-13);
}

BOOST_AUTO_TEST_CASE(damped_head_on_collision_in_closed_form) {
    // Dissipated: mu v^2 (1 - e^2)/2 with e = 0.8. The power jumps from 0 to eta v^2 on touch,
    // which the trapezoid rule knows to half a frame interval: averaged over phases the error
    // vanishes.
    const double v = 1.5;
    constexpr int phases = 20;
    double mean = 0, worst = 0, stated = 0;
    for (int phase = 0; phase < phases; ++phase) {
        // Not a whole fraction of t_col: else the errors of touching and of parting cancel.
        const double interval = t_col / 47.3, t_in = interval * (3 + (phase + 0.5) / phases);
        const auto frames = head_on(interval, t_in, v);
        const auto results = run(damped_scene(2, interval), frames);
        const auto& residual = get(results, "energy_residual");
        mean += residual.value / phases;
        worst = std::max(worst, std::abs(residual.value));
        stated += residual.systematic / phases;
        // Kinetic energy of the relative motion before the contact, mu v^2/2 with mu = 1/2.
        BOOST_TEST(column(results, "energy", "kinetic").front() == v * v / 4, tt::tolerance(1e-13));
        BOOST_TEST(column(results, "energy", "kinetic").back() == 0.64 * v * v / 4,
                   tt::tolerance(1e-13));
    }
    // Half an interval of the jumps eta v^2 and eta (e v)^2, over mu v^2 (1 - e^2)/2, is 0.043.
    BOOST_TEST_MESSAGE("residual: mean " << mean << ", worst " << worst << ", stated " << stated);
    BOOST_TEST(std::abs(mean) < 1e-3);
    BOOST_TEST(worst < 0.043);
    // The stated systematic error is the right size.
    BOOST_TEST(stated > worst / 4);
    BOOST_TEST(stated < worst * 4);
}

BOOST_AUTO_TEST_CASE(every_variant_of_the_law_balances_its_own_motion_only) {
    const double interval = t_col / 400;
    constexpr int phases = 4;
    for (const auto damping : {Damping::full_vector, Damping::normal_only}) {
        for (const auto clipping : {Clipping::none, Clipping::all, Clipping::normal_only}) {
            auto scene = damped_scene(2, interval);
            scene.contact.damping_acts_on = damping;
            scene.contact.clipping = clipping;
            double own = 0, foreign = 0;
            for (int phase = 0; phase < phases; ++phase) {
                const double start = interval * (5 + (phase + 0.5) / phases);
                const auto frames = oblique(scene.contact, interval, start);
                own += get(run(scene, frames), "energy_residual").value / phases;
                auto other = scene;
                other.contact.damping_acts_on =
                    damping == Damping::full_vector ? Damping::normal_only : Damping::full_vector;
                foreign += get(run(other, frames), "energy_residual").value / phases;
            }
            BOOST_TEST_CONTEXT("clipping " << to_string(clipping) << ", damping "
                                           << to_string(damping)) {
                BOOST_TEST_MESSAGE("own law " << own << ", other damping " << foreign);
                // Half an interval of the jumps is 0.005; four phases average most of it out.
                BOOST_TEST(std::abs(own) < 2e-3);
                // At b = d/2 a good part of the motion is tangential.
                BOOST_TEST(std::abs(foreign) > 0.1);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(free_lid_and_frozen_grains_are_accounted_for) {
    // A lid falling freely past a frozen grain out of reach: potential turns into kinetic energy.
    auto scene = damped_scene(2, t_col / 10);
    scene.gravity = 2;
    scene.initial.frozen = {true, true};
    scene.plates = {.stiffness = k, .touches = {}, .bottom = {}, .lid = scene::FreeLid{.mass = 3}};
    std::vector<SyntheticFrame> frames;
    for (int i = 0; i < 20; ++i) {
        const double t = i * t_col / 10;
        SyntheticFrame frame{.step = i, .time = t};
        frame.add_grain(0, 0, 0, 0);
        frame.add_grain(1, 0, 0, 0);  // overlapping and pressed by nothing that moves
        frame.lid = scene::LidState{10 - t * t, -2 * t};
        frames.push_back(std::move(frame));
    }
    const auto results = run(scene, frames);
    BOOST_TEST(std::abs(get(results, "energy_residual").value) < 1e-13);
    BOOST_TEST(column(results, "energy", "gravity").front() == 60);
    BOOST_TEST(column(results, "energy", "elastic").front() == 0);
    BOOST_TEST(column(results, "energy", "kinetic").back() == 1.5 * std::pow(2 * 0.19, 2),
               tt::tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(nothing_where_frames_do_not_tell) {
    const double interval = t_col / 50;
    const auto good = damped_scene(2, interval);
    const auto frames = oblique(good.contact, interval, interval);
    BOOST_TEST(find(run(good, frames), "energy_residual"));
    const auto nothing = [&](const scene::Scene& scene, std::size_t count) {
        const auto results =
            run(scene, {frames.begin(), frames.begin() + static_cast<long>(count)});
        return results.measurements.empty() && results.series.empty();
    };
    auto spinning = good;
    spinning.contact.spins = scene::Spins::on;
    BOOST_TEST(nothing(spinning, frames.size()));
    auto coarse = good;
    coarse.frame_every = 6;  // t_col/8.3
    BOOST_TEST(nothing(coarse, frames.size()));
    auto overdamped = good;
    overdamped.contact.damping = 100;
    BOOST_TEST(nothing(overdamped, frames.size()));
    BOOST_TEST(nothing(good, 2));
    BOOST_TEST(nothing(good, 0));
}
