// Energy put in by moving plates, on driven motions in closed form.
#include "tests/cases/measure/energy_run.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

/// A grain that rides on an oscillating bottom under gravity, never leaving it, in closed form:
/// y'' = k (b cos(w t) - y) - g, y = -g/k + A cos(w t) + B sin(w0 t), w0^2 = k, A = b k/(k - w^2).
struct DrivenGrain {
    double b = 0.05, g = 100, w = 2 * std::numbers::pi / 0.35, B = 0.01;

    [[nodiscard]] scene::Scene scene(double interval) const {
        auto result = damped_scene(1, interval);
        result.gravity = g;
        result.plates = {.stiffness = k,
                         .touches = {},
                         .bottom = scene::PrescribedPlate{.amplitude = b, .period = 0.35},
                         .lid = {}};
        return result;
    }
    [[nodiscard]] std::vector<SyntheticFrame> frames(double interval, double duration = 1) const {
        const double w0 = std::sqrt(k), A = b * k / (k - w * w);
        std::vector<SyntheticFrame> result;
        for (int i = 0; i * interval < duration + 1e-9; ++i) {
            const double t = i * interval;
            const double y = -g / k + A * std::cos(w * t) + B * std::sin(w0 * t);
            const double v = -w * A * std::sin(w * t) + w0 * B * std::cos(w0 * t);
            SyntheticFrame frame{.step = i, .time = t};
            frame.add_grain(0, y, 0, v);
            result.push_back(std::move(frame));
        }
        return result;
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(driven_grain_takes_up_what_the_bottom_gives) {
    const DrivenGrain grain;
    double previous = 0;
    for (const double interval : {t_col / 10, t_col / 20, t_col / 40}) {
        const auto results = run(grain.scene(interval), grain.frames(interval));
        const auto& residual = get(results, "energy_residual");
        BOOST_TEST_MESSAGE("interval " << interval << ": residual " << residual.value << " +- "
                                       << residual.systematic);
        BOOST_TEST(std::abs(residual.value) < 0.1);
        BOOST_TEST(std::abs(residual.value) < residual.systematic);
        // Trapezoid rule on a smooth power: second order.
        if (previous != 0) BOOST_TEST(previous / residual.value == 4.0, tt::tolerance(0.15));
        previous = residual.value;
    }
}

BOOST_AUTO_TEST_CASE(wrong_motion_of_the_bottom_is_noticed) {
    const DrivenGrain grain;
    const double interval = t_col / 40;
    auto scene = grain.scene(interval);
    scene.plates.bottom->period *= 1.05;
    const auto& residual = get(run(scene, grain.frames(interval)), "energy_residual");
    BOOST_TEST(std::abs(residual.value) > 0.05);
}

BOOST_AUTO_TEST_CASE(prescribed_lid_does_work_too) {
    // The driven grain upside down: gravity cannot be turned, so without it and under a lid that
    // presses it against a bottom at rest. y'' = k (-y) + k (h - y), h = -0.3 + b cos(w t).
    const double b = 0.05, w = 2 * std::numbers::pi / 0.35, w0 = std::sqrt(2 * k), c = 0.01;
    const double interval = t_col / 40;
    auto scene = damped_scene(1, interval);
    scene.plates = {.stiffness = k,
                    .touches = {},
                    .bottom = scene::PrescribedPlate{},
                    .lid = scene::PrescribedPlate{.height = -0.3, .amplitude = b, .period = 0.35}};
    const double A = b * k / (2 * k - w * w);
    std::vector<SyntheticFrame> frames;
    for (int i = 0; i < 400; ++i) {
        const double t = i * interval;
        SyntheticFrame frame{.step = i, .time = t};
        frame.add_grain(0, -0.15 + A * std::cos(w * t) + c * std::sin(w0 * t), 0,
                        -w * A * std::sin(w * t) + w0 * c * std::cos(w0 * t));
        frames.push_back(std::move(frame));
    }
    const auto& residual = get(run(scene, frames), "energy_residual");
    BOOST_TEST(std::abs(residual.value) < 0.01);
}

BOOST_AUTO_TEST_CASE(averages_are_over_whole_periods) {
    // Without the free oscillation every period is the same, and the work of the bottom cancels.
    const DrivenGrain grain{.B = 0};
    const double interval = 0.35 / 140;
    measure::EnergyBalance estimator(grain.scene(interval), {.skip = 0.1});
    for (const auto& frame : grain.frames(interval, 0.1 + 20.5 * 0.35)) {
        estimator.add(frame.view());
    }
    measure::Results results;
    estimator.finish(results);
    const double w0_squared = k, A = grain.b * k / (k - grain.w * grain.w);
    // <E> = m w^2 A^2/4 + m g <y> + k <(y_b - y)^2>/2.
    const double mean = std::pow(grain.w * A, 2) / 4 - grain.g * grain.g / w0_squared +
                        k / 2 * (std::pow(grain.g / k, 2) + std::pow(grain.b - A, 2) / 2);
    const auto& energy = get(results, "mean_energy");
    BOOST_TEST(energy.value == mean, tt::tolerance(1e-9));
    BOOST_TEST(energy.standard_error < 1e-9 * std::abs(mean));
    BOOST_TEST(energy.settings.at("skip") == 0.1);
    BOOST_TEST(std::abs(get(results, "mean_energy_input").value) < 1e-9);
    BOOST_TEST(get(results, "mean_dissipation").value == 0);
    BOOST_TEST(get(results, "mean_dissipation").unit == "m l^2/t^3");
}
