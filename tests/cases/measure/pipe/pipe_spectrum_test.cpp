// Exponent in time of the bin densities: noise of known exponent, white noise, a wave's window, and
// frames too far apart.
#include "cases/measure/pipe/pipe_spectrum.hpp"
#include "tests/cases/measure/synthetic_pipe.hpp"

#include <boost/test/unit_test.hpp>

#include <complex>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

/// Gaussian noise with P(f) ~ f^-alpha and unit variance: random phases at every eighth of a
/// frequency step would be exact, a sum over the steps themselves is periodic and good enough here.
std::vector<double> noise(std::size_t points, double alpha, std::uint64_t seed) {
    const std::size_t waves = points / 2;
    std::vector<double> values(points, 0.0);
    double variance = 0;
    for (std::size_t k = 1; k < waves; ++k) {
        const double amplitude = std::pow(static_cast<double>(k), -alpha / 2);
        const auto [a, b] = normal_pair(seed, RandomStream::jitter, k);
        const auto turn = std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(k) /
                                              static_cast<double>(points));
        std::complex<double> wave = amplitude * std::complex<double>(a, b);
        variance += amplitude * amplitude;
        for (double& value : values) {
            value += wave.real();
            wave *= turn;
        }
    }
    for (double& value : values)
        value /= std::sqrt(variance);
    return values;
}

/// Bins in pairs of 40 + 8 s(t) and 40 - 8 s(t) grains, so that none is lost.
measure::Results spectrum_of(double alpha) {
    constexpr std::size_t pairs = 22, per_bin = 40;
    const auto scene = pipe_scene(2 * pairs * per_bin, 220, 409.4);
    measure::PipeSpectrum estimator(scene, {});
    const auto frames = static_cast<std::size_t>(scene.steps / scene.frame_every + 1);
    std::vector<std::vector<double>> signals;
    for (std::size_t p = 0; p < pairs; ++p)
        signals.push_back(noise(frames, alpha, 10 + p));
    auto y = scene.initial.y;
    const std::vector<double> vy(y.size(), -8.0);
    for (std::size_t f = 0; f < frames; ++f) {
        std::size_t grain = 0;
        for (std::size_t p = 0; p < pairs; ++p) {
            const double more = std::clamp(8 * signals[p][f], -40.0, 40.0);
            const auto first = static_cast<std::size_t>(std::lround(per_bin + more));
            for (std::size_t i = 0; i < 2 * per_bin; ++i)
                y[grain++] = -(static_cast<double>(2 * p + (i < first ? 0 : 1)) * 5 + 2.5);
        }
        const auto step = static_cast<std::int64_t>(f) * scene.frame_every;
        estimator.add({.step = step,
                       .time = static_cast<double>(step) * scene.dt,
                       .x = scene.initial.x,
                       .y = y,
                       .vx = scene.initial.vx,
                       .vy = vy,
                       .lid = {},
                       .omega = {}});
    }
    measure::Results results;
    estimator.finish(results);
    return results;
}

}  // namespace

BOOST_AUTO_TEST_CASE(known_exponents_within_a_tenth) {
    for (const double alpha : {0.0, 1.0, 1.33}) {
        const auto measured = get(spectrum_of(alpha), "alpha");
        BOOST_TEST_MESSAGE("alpha " << alpha << ": " << measured.value << " +- "
                                    << measured.standard_error << ", window "
                                    << measured.settings.at("decades") << " decades");
        BOOST_TEST(std::abs(measured.value - alpha) < 0.1);
        BOOST_TEST(std::abs(measured.value - alpha) < 4 * measured.standard_error + 0.05);
        BOOST_TEST(measured.settings.at("peak") == 0.0);
        BOOST_TEST(measured.settings.at("f_max") == 0.35 * 8 / 5, tt::tolerance(1e-9));
        BOOST_TEST(measured.settings.at("f_min") == 1.5 * 8 / 220, tt::tolerance(1e-9));
    }
}

BOOST_AUTO_TEST_CASE(the_window_starts_above_the_wave) {
    const auto scene = pipe_scene(420);
    measure::PipeSpectrum estimator(scene, {});
    const auto results =
        SyntheticPipe(scene, {.shape = cosine_wave(0.6), .diffusion = 0.5}).run(estimator);
    const auto alpha = get(results, "alpha");
    // The resolution is one in 125 time units.
    BOOST_TEST(std::abs(alpha.settings.at("peak") - 11.3 / 220) < 1.0 / 125);
    BOOST_TEST(alpha.settings.at("f_min") == 1.5 * alpha.settings.at("peak"), tt::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(frames_too_far_apart_are_refused) {
    auto scene = pipe_scene(100, 220, 2000);
    scene.frame_every = 80;
    measure::PipeSpectrum estimator(scene, {});
    const auto results = SyntheticPipe(scene, {}).run(estimator);
    BOOST_TEST(label(results, "sampling") == "too coarse");
    BOOST_TEST(results.measurements.empty());
    BOOST_TEST(results.series.empty());
}

BOOST_AUTO_TEST_CASE(options_that_make_no_sense_are_refused) {
    const auto scene = pipe_scene(10);
    const auto make = [&](measure::PipeSpectrumOptions o) {
        measure::PipeSpectrum estimator(scene, o);
    };
    BOOST_CHECK_THROW(make({.segments = 1}), std::invalid_argument);
    BOOST_CHECK_THROW(make({.low = 0}), std::invalid_argument);
    BOOST_CHECK_THROW(make({.high = 0.6}), std::invalid_argument);
}
