// Lid heights that are known, for free and prescribed lids.
#include "cases/measure/bed/lid_height.hpp"

#include "native/base/random.hpp"
#include "tests/cases/measure/synthetic_frame.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

scene::Scene bed() {
    auto scene = plain_scene(1);
    scene.plates = {.stiffness = 1,
                    .touches = {},
                    .bottom = scene::PrescribedPlate{.height = 0.5, .amplitude = 2, .period = 6},
                    .lid = scene::FreeLid{.mass = 0.1}};
    return scene;
}

measure::Results run(const scene::Scene& scene, double skip, std::size_t frames) {
    measure::LidHeight estimator(scene, {.skip = skip});
    for (std::size_t i = 0; i < frames; ++i) {
        SyntheticFrame frame{.time = 0.1 * static_cast<double>(i)};
        frame.add_grain(0, 0, 0, 0);
        // White noise about 30 after a start at 100 that must be skipped.
        const double noise = normal_pair(1, RandomStream::jitter, i)[0];
        frame.lid = scene::LidState{frame.time < 5 ? 100.0 : 30 + noise, 0};
        estimator.add(frame.view());
    }
    measure::Results results;
    estimator.finish(results);
    return results;
}

}  // namespace

BOOST_AUTO_TEST_CASE(mean_and_error_after_the_transient) {
    const auto results = run(bed(), 5.0 - 1e-9, 24050);
    const auto& mean = get(results, "mean_lid_height");
    // 24000 independent samples of unit variance in 400 periods of the bottom.
    BOOST_TEST(mean.standard_error == 1 / std::sqrt(24000.0), tt::tolerance(0.3));
    BOOST_TEST(std::abs(mean.value - 30) < 4 * mean.standard_error);
}

BOOST_AUTO_TEST_CASE(series_has_bottom_and_spacing) {
    const auto results = run(bed(), 0, 100);
    const auto& t = column(results, "lid-height", "t");
    const auto& h = column(results, "lid-height", "h");
    const auto& bottom = column(results, "lid-height", "bottom");
    const auto& spacing = column(results, "lid-height", "spacing");
    BOOST_TEST_REQUIRE(t.size() == 100U);
    for (std::size_t i = 0; i < t.size(); ++i) {
        const double height = 0.5 + 2 * std::cos(2 * std::acos(-1.0) / 6 * t[i]);
        BOOST_TEST(bottom[i] == height, tt::tolerance(1e-12));
        BOOST_TEST(spacing[i] == h[i] - bottom[i]);
    }
}

BOOST_AUTO_TEST_CASE(a_short_run_has_a_series_but_no_mean) {
    const auto results = run(bed(), 0, 6);
    BOOST_TEST(!find(results, "mean_lid_height"));
    BOOST_TEST(column(results, "lid-height", "h").size() == 6U);
}

BOOST_AUTO_TEST_CASE(prescribed_lid_is_known_without_the_frame) {
    auto scene = bed();
    scene.plates.lid = scene::PrescribedPlate{.height = 20};
    scene.plates.bottom.reset();
    const auto results = run(scene, 0, 50);
    BOOST_TEST(get(results, "mean_lid_height").value == 20);
    BOOST_TEST(get(results, "mean_lid_height").standard_error == 0);
    BOOST_TEST(results.series[0].columns.size() == 2U);
}

BOOST_AUTO_TEST_CASE(no_lid_no_results) {
    auto scene = bed();
    scene.plates.lid = std::monostate{};
    const auto results = run(scene, 0, 50);
    BOOST_TEST(results.measurements.empty());
    BOOST_TEST(results.series.empty());
}
