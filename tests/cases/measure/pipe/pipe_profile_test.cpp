// Shape of a wave of grains: a symmetric wave, one with a sharper front, one with a sharper back,
// and grains without a wave, of which maximal overlap makes a peak too. And its picture.
#include "cases/measure/pipe/pipe_picture.hpp"
#include "cases/measure/pipe/pipe_profile.hpp"
#include "tests/cases/measure/synthetic_pipe.hpp"

#include <boost/test/unit_test.hpp>

#include <complex>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

/// Rises from 0.3 over the share `rise` of the period to 1.7, and falls back over the rest.
std::function<double(double)> sawtooth(double rise) {
    return [=](double xi) { return 0.3 + 1.4 * (xi < rise ? xi / rise : (1 - xi) / (1 - rise)); };
}

measure::Results profile(std::function<double(double)> shape) {
    const auto scene = pipe_scene(420, 220, 500);
    measure::PipeProfile estimator(scene, {});
    return SyntheticPipe(scene, {.shape = std::move(shape), .diffusion = 1.5}).run(estimator);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_sharper_side_is_found) {
    // Downward the density first rises over 0.75 L: the back is flat, the front three times as
    // steep.
    const auto front = get(profile(sawtooth(0.75)), "profile_asymmetry");
    BOOST_TEST_MESSAGE("ln 3 = 1.10: " << front.value << " +- " << front.standard_error);
    BOOST_TEST(front.value == std::log(3.0), tt::tolerance(0.2));
    BOOST_TEST(get(profile(sawtooth(0.75)), "profile_front_sharper").value == 1.0);
    const auto back = get(profile(sawtooth(0.25)), "profile_asymmetry");
    BOOST_TEST(back.value == -std::log(3.0), tt::tolerance(0.2));
}

BOOST_AUTO_TEST_CASE(a_symmetric_wave_has_no_asymmetry_and_its_amplitude) {
    const auto results = profile(cosine_wave(0.6));
    const auto asymmetry = get(results, "profile_asymmetry");
    BOOST_TEST_MESSAGE("symmetric: " << asymmetry.value << " +- " << asymmetry.standard_error
                                     << ", amplitude " << get(results, "profile_amplitude").value
                                     << ", excess " << get(results, "profile_excess").value);
    BOOST_TEST(std::abs(asymmetry.value) < 0.2);
    BOOST_TEST(std::abs(asymmetry.value) < 4 * asymmetry.standard_error);
    BOOST_TEST(get(results, "profile_amplitude").value == 0.6, tt::tolerance(0.15));
}

BOOST_AUTO_TEST_CASE(noise_has_no_excess_over_shuffled_bins) {
    const auto scene = pipe_scene(840, 220, 110);
    measure::PipeProfile estimator(scene, {});
    const auto results = RandomPipe(scene, 8, 9).run(estimator);
    const auto excess = get(results, "profile_excess");
    BOOST_TEST(get(results, "profile_null_amplitude").value > 0.05);
    BOOST_TEST(std::abs(excess.value) < 0.05);
}

BOOST_AUTO_TEST_CASE(the_picture_shows_the_wave_moving_to_the_right_and_up) {
    auto scene = pipe_scene(4000, 220, 4);
    measure::PipePicture estimator(scene, {});
    const auto results = SyntheticPipe(scene, {.shape = cosine_wave(0.9)}).run(estimator);
    const auto& picture = results.pictures.front();
    BOOST_TEST(picture.name == "space-time");
    BOOST_TEST(picture.width == 110U);
    BOOST_TEST(picture.height == 21U);
    // Phase of the longest wave in a row, in pixels.
    const auto crest = [&](std::size_t row) {
        std::complex<double> sum;
        for (std::size_t x = 0; x < picture.width; ++x) {
            sum += std::polar(static_cast<double>(picture.pixels[row * picture.width + x]),
                              2 * std::numbers::pi * static_cast<double>(x) / 110);
        }
        return std::arg(sum) / (2 * std::numbers::pi) * 110;
    };
    // In 4 time units 45.2 l, 22.6 pixels; the last instant is the top row.
    const double moved = std::fmod(crest(0) - crest(picture.height - 1) + 110, 110);
    BOOST_TEST(std::abs(moved - 22.6) < 2);
    BOOST_CHECK_THROW(measure::PipePicture(scene, {.rows = 1}), std::invalid_argument);
}
