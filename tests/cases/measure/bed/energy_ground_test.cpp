// Energy of a bed above its ground state against the input of a period, and powers sampled between
// frames, on motions in closed form.
#include "tests/cases/measure/energy_run.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

constexpr double period = 0.5, b = 0.01, g = 100;

/// Eight grains that ride on the bottom in the closed form of a steadily driven oscillator with
/// drag: y = -g/k + A cos(w t - phase) gives a mean input of k b w A sin(phase)/2 per grain.
struct SteadyBed {
    double amplitude = 0.012, phase = 0.3, w = 2 * std::numbers::pi / period;

    [[nodiscard]] scene::Scene scene(double interval) const {
        auto result = damped_scene(8, interval);
        result.gravity = g;
        result.periodic_x = 16 * d;  // 16 columns: all eight grains lie in the lowest row
        result.plates = {.stiffness = k,
                         .touches = {},
                         .bottom = scene::PrescribedPlate{.amplitude = b, .period = period},
                         .lid = {}};
        return result;
    }
    [[nodiscard]] std::vector<SyntheticFrame> frames(double interval) const {
        std::vector<SyntheticFrame> result;
        for (int i = 0; i * interval < 12 * period + 1e-9; ++i) {
            const double t = i * interval;
            SyntheticFrame frame{.step = i, .time = t};
            for (int n = 0; n < 8; ++n) {
                frame.add_grain(2 * d * n, -g / k + amplitude * std::cos(w * t - phase), 0,
                                -w * amplitude * std::sin(w * t - phase));
            }
            result.push_back(std::move(frame));
        }
        return result;
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(input_of_a_period_and_energy_above_ground) {
    const SteadyBed bed;
    const double interval = t_col / 20;
    const auto results = run(bed.scene(interval), bed.frames(interval));
    const double power = 8 * k * b * bed.w * bed.amplitude * std::sin(bed.phase) / 2;
    BOOST_TEST(get(results, "mean_energy_input").value == power, tt::tolerance(1e-6));
    const auto& per_period = get(results, "input_per_period");
    BOOST_TEST(per_period.value == power * period, tt::tolerance(1e-6));
    const auto& above = get(results, "energy_above_ground");
    // All grains lie in the lowest row, at the bottom's mean height: the ground state has energy 0.
    BOOST_TEST(above.settings.at("ground_energy") == 0.0);
    BOOST_TEST(above.value == get(results, "mean_energy").value);
    BOOST_TEST(get(results, "energy_per_input").value == above.value / per_period.value,
               tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(ground_state_is_the_closest_packing_with_the_lid_on_top) {
    const SteadyBed bed;
    const double interval = t_col / 20;
    auto scene = bed.scene(interval);
    scene.periodic_x = 2 * d;  // two columns, four rows
    scene.plates.lid = scene::FreeLid{.mass = 7};
    auto frames = bed.frames(interval);
    for (auto& frame : frames)
        frame.lid = scene::LidState{50, 0};
    const auto results = run(scene, frames);
    const double row = std::numbers::sqrt3 / 2 * d;
    BOOST_TEST(get(results, "energy_above_ground").settings.at("ground_energy") ==
                   g * row * (2 * (1 + 2 + 3) + 7 * 3),
               tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(no_ground_state_without_gravity_or_drive) {
    const SteadyBed bed;
    const double interval = t_col / 20;
    auto weightless = bed.scene(interval);
    weightless.gravity = 0;
    BOOST_TEST(!find(run(weightless, bed.frames(interval)), "energy_above_ground"));
    auto open = bed.scene(interval);
    open.periodic_x.reset();
    BOOST_TEST(!find(run(open, bed.frames(interval)), "energy_per_input"));
}

BOOST_AUTO_TEST_CASE(sampling_between_frames_removes_the_error_of_the_sum) {
    // A grain driven without losses, so that the true residual is 0 (see energy_input_test); its
    // frames are exact, and what is left is the sum over the powers.
    const double w = 2 * std::numbers::pi / 0.35, w0 = std::sqrt(k), interval = t_col / 10;
    const double A = 0.05 * k / (k - w * w), B = 0.01;
    auto scene = damped_scene(1, interval);
    scene.gravity = g;
    scene.plates = {.stiffness = k,
                    .touches = {},
                    .bottom = scene::PrescribedPlate{.amplitude = 0.05, .period = 0.35},
                    .lid = {}};
    std::vector<SyntheticFrame> frames;
    for (int i = 0; i <= 100; ++i) {
        const double t = i * interval;
        SyntheticFrame frame{.step = i, .time = t};
        frame.add_grain(0, -g / k + A * std::cos(w * t) + B * std::sin(w0 * t), 0,
                        -w * A * std::sin(w * t) + w0 * B * std::cos(w0 * t));
        frames.push_back(std::move(frame));
    }
    const double coarse = get(run(scene, frames), "energy_residual").value;
    const auto fine = get(run(scene, frames, {.samples_per_frame = 8}), "energy_residual");
    BOOST_TEST(std::abs(fine.value) < std::abs(coarse) / 30);
    BOOST_TEST(fine.systematic < std::abs(coarse) / 10);
    BOOST_TEST(fine.settings.at("samples_per_contact_time") == 80.0, tt::tolerance(1e-9));
    BOOST_CHECK_THROW(measure::EnergyBalance(scene, {.samples_per_frame = 0}),
                      std::invalid_argument);
}
