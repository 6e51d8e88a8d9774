// Lattices whose rows move with velocities of known spectrum.
#include "cases/measure/bed/velocity_spectrum.hpp"
#include "native/base/random.hpp"
#include "tests/cases/measure/synthetic_frame.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;
using measure::VelocitySpectrumOptions;

namespace {

constexpr int columns = 64, rows = 8;
constexpr double pi = std::numbers::pi, period = 6;

scene::Scene lattice() {
    auto scene = plain_scene(columns * rows);
    scene.periodic_x = 2.0 * columns;
    scene.dt = 0.1;
    scene.frame_every = 1;
    scene.plates = {.stiffness = 1,
                    .touches = {},
                    .bottom = scene::PrescribedPlate{},
                    .lid = scene::PrescribedPlate{.height = 13, .amplitude = 1, .period = period}};
    for (std::size_t i = 0; i < scene.initial.x.size(); ++i) {
        const auto row = i / columns;
        scene.initial.x[i] = 2.0 * static_cast<double>(i % columns) + (row % 2 == 0 ? 0.5 : 1.5);
        scene.initial.y[i] = 1.75 * static_cast<double>(row);
    }
    return scene;
}

/// |FFT|^2 of every row = size K^exponent, phases random.
std::vector<double> velocities(double exponent, double size, std::uint64_t seed) {
    std::vector<double> v(columns * rows, 0.0);
    for (int row = 0; row < rows; ++row) {
        for (int k = 1; k <= columns / 2; ++k) {
            const bool nyquist = k == columns / 2;
            const auto draw = static_cast<std::uint64_t>(row * columns + k);
            const double phase = nyquist ? 0 : 2 * pi * uniform(seed, RandomStream::jitter, draw);
            const double amplitude =
                std::sqrt(size) * std::pow(k, exponent / 2) * (nyquist ? 1.0 : 2.0) / columns;
            for (int i = 0; i < columns; ++i) {
                v[static_cast<std::size_t>(row * columns + i)] +=
                    amplitude * std::cos(2 * pi * k * i / columns + phase);
            }
        }
    }
    return v;
}

/// Frames at 0, 0.1, ..., with exponent and size of the spectrum given as functions of the paper's
/// time.
measure::Results run(
    const VelocitySpectrumOptions& options, double duration,
    const std::function<double(double)>& exponent,
    const std::function<double(double)>& size = [](double) { return 1.0; },
    const scene::Scene& scene = lattice()) {
    measure::VelocitySpectrum estimator(scene, options);
    for (int f = 0; f * 0.1 < duration + 1e-9; ++f) {
        SyntheticFrame frame{.step = f, .time = f * 0.1};
        frame.x = scene.initial.x;
        frame.y = scene.initial.y;
        const double t = options.clock + frame.time;
        frame.vx = velocities(exponent(t), size(t), static_cast<std::uint64_t>(f));
        frame.vy.assign(frame.vx.size(), 0.0);
        estimator.add(frame.view());
    }
    measure::Results results;
    estimator.finish(results);
    return results;
}

}  // namespace

BOOST_AUTO_TEST_CASE(slope_at_stated_times_of_the_papers_clock) {
    const auto results =
        run({.clock = 1.5, .times = {1.5, 2, 2.34}}, 1, [](double t) { return -t; });
    BOOST_TEST(get(results, "velocity_slope_t1.5").value == -1.5, tt::tolerance(1e-10));
    BOOST_TEST(get(results, "velocity_slope_t2").value == -2.0, tt::tolerance(1e-10));
    // The nearest frame.
    const auto& between = get(results, "velocity_slope_t2.34");
    BOOST_TEST(between.value == -2.3, tt::tolerance(1e-10));
    BOOST_TEST(between.settings.at("t") == 2.3, tt::tolerance(1e-10));
    BOOST_TEST(between.n == 8U);
    BOOST_TEST(between.systematic < 1e-9);
    for (const char* window : {"_K1_8", "_K1_16", "_K1_32"}) {
        BOOST_TEST(get(results, std::string("velocity_slope_t2") + window).value == -2.0,
                   tt::tolerance(1e-10));
    }
    const auto times = column(results, "velocity-slope", "t");
    BOOST_TEST(times.size() == 11U);
    BOOST_TEST(column(results, "velocity-slope", "slope_K1_16")[10] == -2.5, tt::tolerance(1e-10));
    const auto spectrum = column(results, "velocity-spectrum", "E_t2");
    BOOST_TEST_REQUIRE(spectrum.size() == 32U);
    BOOST_TEST(spectrum[1] == std::pow(2.0, -2), tt::tolerance(1e-10));
}

BOOST_AUTO_TEST_CASE(a_time_outside_of_the_run_is_not_reported) {
    const auto results = run({.clock = 1.5, .times = {1.0, 9}}, 1, [](double) { return -1.0; });
    BOOST_TEST(!find(results, "velocity_slope_t1"));
    BOOST_TEST(!find(results, "velocity_slope_t9"));
}

BOOST_AUTO_TEST_CASE(spread_over_the_windows_is_the_systematic_error) {
    // White beyond K = 16: mixing two power laws bends the spectrum.
    auto scene = lattice();
    measure::VelocitySpectrum estimator(scene, {.times = {0}});
    SyntheticFrame frame;
    frame.x = scene.initial.x;
    frame.y = scene.initial.y;
    frame.vy.assign(scene.initial.x.size(), 0.0);
    const auto steep = velocities(-3, 1, 1), white = velocities(0, 1e-3, 1);
    for (std::size_t i = 0; i < steep.size(); ++i)
        frame.vx.push_back(steep[i] + white[i]);
    estimator.add(frame.view());
    measure::Results results;
    estimator.finish(results);
    const double k8 = get(results, "velocity_slope_t0_K1_8").value;
    const double k32 = get(results, "velocity_slope_t0_K1_32").value;
    BOOST_TEST(k8 < k32 - 0.3);
    BOOST_TEST(get(results, "velocity_slope_t0").systematic == (k32 - k8) / 2,
               tt::tolerance(1e-10));
}

BOOST_AUTO_TEST_CASE(phases_are_averaged_over_their_passages) {
    // The exponent follows the drive: -1 - cos(2 pi t/T).
    const auto exponent = [](double t) { return -1 - std::cos(2 * pi * t / period); };
    const auto results =
        run({.clock = 1.5, .phases = {0, 60, 180}, .skip = 6}, 4 * period, exponent);
    const auto& at_zero = get(results, "velocity_slope_phase0");
    BOOST_TEST(at_zero.value == -2.0, tt::tolerance(1e-6));
    BOOST_TEST(at_zero.n == 4U);  // t = 6, 12, 18, 24
    BOOST_TEST(get(results, "velocity_slope_phase60").value == -1.5, tt::tolerance(1e-6));
    BOOST_TEST(std::abs(get(results, "velocity_slope_phase180").value) < 1e-6);
    BOOST_TEST(get(results, "velocity_slope_steepest").settings.at("phase") == 0.0);
    BOOST_TEST(get(results, "velocity_slope_flattest").settings.at("phase") == 180.0);
    BOOST_TEST(get(results, "velocity_slope_steepest").value == -2.0, tt::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(a_window_weighs_every_spectrum_alike) {
    // The motion dies away by 1e-6 over the window while its spectrum becomes white: an average of
    // powers would know the steep beginning only.
    const auto size = [](double t) { return std::pow(10.0, -t); };
    const auto exponent = [](double t) { return t < 1 ? -2.0 : 0.0; };
    const auto results = run({.from = 0, .to = 6}, 6.2, exponent, size);
    BOOST_TEST(get(results, "velocity_slope_window").value > -0.7);
    BOOST_TEST(get(results, "transverse_energy_window").value > 0);
}

BOOST_AUTO_TEST_CASE(transverse_energy_is_that_of_the_velocities_across) {
    const auto results = run({.times = {0}}, 0.1, [](double) { return -1.0; });
    double sum = 0;
    for (const double v : velocities(-1, 1, 0))
        sum += v * v / 2;
    BOOST_TEST(get(results, "transverse_energy_t0").value == sum / (columns * rows),
               tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(says_nothing_about_states_that_are_no_lattice) {
    auto jittered = lattice();
    jittered.initial.y[5] += 0.01;
    const auto white = [](double) { return 0.0; };
    const auto one = [](double) { return 1.0; };
    BOOST_TEST(run({.times = {0}}, 1, white, one, jittered).measurements.empty());
    auto open = lattice();
    open.periodic_x.reset();
    BOOST_TEST(run({.times = {0}}, 1, white, one, open).measurements.empty());
}

BOOST_AUTO_TEST_CASE(rejects_options_that_make_no_sense) {
    const auto scene = lattice();
    const auto make = [&](const VelocitySpectrumOptions& options) {
        measure::VelocitySpectrum estimator(scene, options);
    };
    BOOST_CHECK_THROW(make({.phases = {360}}), std::invalid_argument);
    BOOST_CHECK_THROW(make({.from = 3}), std::invalid_argument);
    BOOST_CHECK_THROW(make({.from = 3, .to = 2}), std::invalid_argument);
    BOOST_CHECK_THROW(make({.k_min = 0}), std::invalid_argument);
}
