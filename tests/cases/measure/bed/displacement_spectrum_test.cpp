// Beds with displacement fields of known spectrum, whose lid passes h0 at known times.
#include "cases/measure/bed/displacement_spectrum.hpp"

#include "tests/cases/measure/displacement_bed.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;
using measure::Crossing;
using measure::DisplacementSpectrumOptions;

namespace {

const std::vector<std::string> groups{"1_5", "6_10", "11_15", "16_20"};

}  // namespace

BOOST_AUTO_TEST_CASE(exact_power_law_gives_its_exponent) {
    const auto results = run(4, exact_power_law([](int) { return -5.0 / 3; }), {});
    BOOST_TEST(get(results, "displacement_vectors").value == 4);
    for (const auto& group : groups) {
        const auto& slope = get(results, "slope_" + group);
        // Displacements of 1e-7 in positions of 1e2 are known to 1e-7.
        BOOST_TEST(slope.value == -5.0 / 3, tt::tolerance(1e-6));
        BOOST_TEST(slope.standard_error < 1e-6);
        BOOST_TEST(slope.systematic < 1e-6);
        BOOST_TEST(slope.n == 4U);
        BOOST_TEST(slope.settings.at("k_min") == 1);
        BOOST_TEST(slope.settings.at("k_max") == 16);
        BOOST_TEST(slope.settings.at("vectors") == 4);
        BOOST_TEST(get(results, "slope_tail_" + group).value == -5.0 / 3, tt::tolerance(1e-5));
        const auto& spectrum = column(results, "spectrum", "S_" + group);
        BOOST_TEST_REQUIRE(spectrum.size() == 32U);
        BOOST_TEST(spectrum[0] == small * small, tt::tolerance(1e-6));
        BOOST_TEST(spectrum[31] == small * small * std::pow(32, -5.0 / 3), tt::tolerance(1e-6));
    }
    for (const double amplitude : column(results, "spectrum-fit", "amplitude")) {
        BOOST_TEST(amplitude == small * small, tt::tolerance(1e-5));
    }
}

BOOST_AUTO_TEST_CASE(layers_are_counted_from_the_moving_bottom) {
    // Every group its own exponent; the bottom moves by more than two layers.
    const auto results =
        run(4, exact_power_law([](int layer) { return -0.5 * ((layer - 1) / 5); }), {});
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const double exponent = -0.5 * static_cast<double>(g);
        BOOST_TEST(std::abs(get(results, "slope_" + groups[g]).value - exponent) < 1e-6);
    }
}

BOOST_AUTO_TEST_CASE(downward_crossings) {
    const auto field = exact_power_law([](int) { return -1.0; });
    const auto down = run(4, field, {.crossing = Crossing::downward});
    BOOST_TEST(get(down, "displacement_vectors_downward").value == 4);
    BOOST_TEST(get(down, "slope_1_5_downward").value == -1.0, tt::tolerance(1e-6));
    BOOST_TEST(!find(down, "slope_1_5"));
    BOOST_TEST(column(down, "spectrum-downward", "K").size() == 32U);
}

BOOST_AUTO_TEST_CASE(crossings_either_way_double_the_vectors) {
    // Grains jump at the downward crossing that ends a vector, at the latest: every second vector
    // holds the displacement, the others are empty.
    const auto field = exact_power_law([](int) { return -1.0; });
    const auto both = run(4, field, {.crossing = Crossing::either});
    BOOST_TEST(get(both, "displacement_vectors_either").value >= 7);
    BOOST_TEST(get(both, "slope_1_5_either").value == -1.0, tt::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(slopes_over_the_stated_windows) {
    const auto results = run(4, exact_power_law([](int) { return -1.5; }), {});
    BOOST_TEST(get(results, "slope_1_5_K1_8").value == -1.5, tt::tolerance(1e-6));
    BOOST_TEST(get(results, "slope_1_5_K1_8").settings.at("k_max") == 8);
    BOOST_TEST(get(results, "slope_16_20_K1_32").value == -1.5, tt::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(field_of_the_last_vector_is_kept) {
    const auto results = run(
        3, [](int n, int layer, int cell) { return 1e-3 * n + 1e-5 * layer + 1e-7 * cell; }, {});
    const auto dx = column(results, "displacement-field", "dx");
    const auto x = column(results, "displacement-field", "x");
    const auto y = column(results, "displacement-field", "y");
    BOOST_TEST_REQUIRE(dx.size() == static_cast<std::size_t>(cells * layers));
    // The third vector (n = 2), grain 3 of layer 2.
    const std::size_t grain = cells + 3;
    BOOST_TEST(dx[grain] == 2e-3 + 2e-5 + 3e-7, tt::tolerance(1e-8));
    BOOST_TEST(y[grain] == 1.4 * cell_height, tt::tolerance(1e-9));
    for (const double position : x) {
        BOOST_TEST_REQUIRE(position >= 0);
        BOOST_TEST_REQUIRE(position < length);
    }
}

BOOST_AUTO_TEST_CASE(transient_is_skipped) {
    const auto field = exact_power_law([](int) { return -1.0; });
    BOOST_TEST(get(run(6, field, {.skip = 2.5 * period}), "displacement_vectors").value == 4);
}

BOOST_AUTO_TEST_CASE(jackknife_error_is_the_scatter_of_realisations) {
    constexpr int realisations = 200, vectors = 20;
    struct Sums {
        double value = 0, squares = 0, stated = 0, blocks = 0;
    } slope, tail;
    for (int r = 0; r < realisations; ++r) {
        const auto results = run(vectors, random_power_law(-5.0 / 3, static_cast<std::uint64_t>(r)),
                                 {.groups = {{1, 5}}});
        const auto collect = [&](const char* name, Sums& sums) {
            const auto& one = get(results, name);
            const double off = one.value + 5.0 / 3;
            sums.value += off / realisations;
            sums.squares += off * off / realisations;
            sums.stated += one.standard_error / realisations;
            sums.blocks += one.settings.at("stderr_blocks_of_two") / realisations;
        };
        collect("slope_1_5", slope);
        collect("slope_tail_1_5", tail);
    }
    for (const auto& [name, sums] : {std::pair{"slope", slope}, {"tail", tail}}) {
        const double scatter = std::sqrt(sums.squares - sums.value * sums.value);
        BOOST_TEST_MESSAGE(name << ": bias " << sums.value << ", scatter " << scatter
                                << ", jackknife/scatter " << sums.stated / scatter
                                << ", blocks of two/scatter " << sums.blocks / scatter);
        // 200 realisations know the scatter to 5 %.
        BOOST_TEST(sums.stated == scatter, tt::tolerance(0.25));
        BOOST_TEST(sums.blocks == scatter, tt::tolerance(0.25));
        BOOST_TEST(std::abs(sums.value) < 4 * scatter / std::sqrt(double{realisations}));
    }
}

BOOST_AUTO_TEST_CASE(white_displacements_have_a_flat_spectrum) {
    const Field white = [](int n, int layer, int cell) {
        const auto draw = static_cast<std::uint64_t>((n * 32 + layer) * 64 + cell);
        return small * normal_pair(7, RandomStream::jitter, draw)[0];
    };
    const auto results = run(40, white, {});
    for (const auto& group : groups) {
        for (const auto& name : {"slope_" + group, "slope_tail_" + group}) {
            const auto& slope = get(results, name);
            BOOST_TEST(std::abs(slope.value) < 4 * slope.standard_error);
        }
        // Four standard errors must be able to tell white from -5/3.
        BOOST_TEST(get(results, "slope_" + group).standard_error < 0.1);
        // <S> = 64 cells of variance small^2; 200 periodograms per K know it to 7 %.
        const auto& spectrum = column(results, "spectrum", "S_" + group);
        const auto& error = column(results, "spectrum", "err_" + group);
        BOOST_TEST(spectrum[10] == 64 * small * small, tt::tolerance(0.3));
        BOOST_TEST(error[10] == 0.07 * spectrum[10], tt::tolerance(0.5));
    }
}

BOOST_AUTO_TEST_CASE(a_bent_spectrum_has_a_systematic_error) {
    // Slope -2 below K = 8, flat above: the windows disagree and the error says so.
    const Field bent = [](int n, int layer, int cell) {
        double sum = 0;
        for (int k = 1; k < cells / 2; ++k) {
            const auto draw = static_cast<std::uint64_t>((n * 32 + layer) * 64 + k);
            const double phase = 2 * pi * uniform(1, RandomStream::jitter, draw);
            sum += small / std::min(k, 8) * std::cos(2 * pi * k * cell / cells + phase);
        }
        return sum;
    };
    const auto& slope = get(run(4, bent, {}), "slope_1_5");
    BOOST_TEST(slope.systematic > 0.2);
    BOOST_TEST(slope.value > -1.8);
}

BOOST_AUTO_TEST_CASE(crossing_times_and_positions_between_frames) {
    // One grain per layer on a cubic path, which Hermite interpolation follows exactly: |FFT|^2 is
    // the squared displacement between the exact crossings t = n T, for every K.
    const auto scene = bed();
    const auto path = [](double t) { return 50 + 0.01 * t + 2e-4 * t * t - 1e-5 * t * t * t; };
    const auto speed = [](double t) { return 0.01 + 4e-4 * t - 3e-5 * t * t; };
    for (const double interval : {0.5, 0.25, 0.125}) {
        measure::DisplacementSpectrum estimator(scene, {.spacing = h0, .groups = {{1, 1}}});
        for (double t = -1.1; t < 3.5 * period; t += interval) {
            SyntheticFrame frame{.time = t};
            const auto bottom = measure::plate_state(*scene.plates.bottom, t);
            frame.add_grain(path(t), bottom.height + 0.5, speed(t), bottom.velocity);
            set_lid(frame, scene);
            estimator.add(frame.view());
        }
        measure::Results results;
        estimator.finish(results);
        double expected = 0;
        for (int n = 0; n < 3; ++n) {
            expected += std::pow(path((n + 1) * period) - path(n * period), 2) / 3;
        }
        const double found = column(results, "spectrum", "S_1_1")[4];
        BOOST_TEST_MESSAGE("interval " << interval << ": relative error " << found / expected - 1);
        // The error of the crossing time is that of the lid's cubic, (interval/T)^4 of a period.
        BOOST_TEST(found == expected, tt::tolerance(100 * std::pow(interval / period, 4)));
    }
}

BOOST_AUTO_TEST_CASE(a_chattering_lid_counts_once_per_half_period) {
    const auto scene = bed();
    measure::DisplacementSpectrum estimator(scene, {.spacing = h0, .groups = {{1, 1}}});
    for (double t = 0.05; t < 10 * period; t += 0.1) {
        SyntheticFrame frame{.time = t};
        frame.add_grain(1e-3 * t, measure::plate_state(*scene.plates.bottom, t).height + 0.5, 1e-3,
                        0);
        // Ten crossings upwards per period.
        const auto bottom = measure::plate_state(*scene.plates.bottom, t);
        frame.lid =
            scene::LidState{bottom.height + h0 + std::sin(20 * pi * t / period), bottom.velocity};
        estimator.add(frame.view());
    }
    measure::Results results;
    estimator.finish(results);
    // Twice per period in ten periods, less the incomplete ends.
    BOOST_TEST(get(results, "displacement_vectors").value <= 20);
    BOOST_TEST(get(results, "displacement_vectors").value >= 16);
}

BOOST_AUTO_TEST_CASE(grains_far_around_the_period_fall_into_the_same_cells) {
    const auto field = exact_power_law([](int) { return -1.0; });
    const Field shifted = [&](int n, int layer, int cell) {
        // The first vector also carries everything three periods to the left.
        return field(n, layer, cell) - (n == 0 ? 3 * length : 0.0);
    };
    const auto results = run(4, shifted, {.skip = 1.5 * period});
    BOOST_TEST(get(results, "displacement_vectors").value == 3);
    BOOST_TEST(get(results, "slope_1_5").value == -1.0, tt::tolerance(1e-5));
}

BOOST_AUTO_TEST_CASE(a_spacing_never_reached_gives_nothing) {
    const auto field = exact_power_law([](int) { return -1.0; });
    for (const double wrong : {30.0, 50.0}) {
        const auto results = run(6, field, {.spacing = wrong});
        BOOST_TEST(results.measurements.empty());
        BOOST_TEST(results.series.empty());
    }
}

BOOST_AUTO_TEST_CASE(two_vectors_are_not_enough) {
    const auto results = run(2, exact_power_law([](int) { return -1.0; }), {});
    BOOST_TEST(results.measurements.size() == 1U);
    BOOST_TEST(get(results, "displacement_vectors").value == 2);
    BOOST_TEST(results.series.empty());
}

BOOST_AUTO_TEST_CASE(empty_layers_have_no_slope) {
    const auto results =
        run(4, exact_power_law([](int) { return -1.0; }), {.groups = {{1, 5}, {21, 25}}});
    BOOST_TEST(find(results, "slope_1_5"));
    BOOST_TEST(!find(results, "slope_21_25"));
}

BOOST_AUTO_TEST_CASE(scenes_that_have_no_such_spectrum_give_nothing) {
    const auto field = exact_power_law([](int) { return -1.0; });
    auto open = bed();
    open.periodic_x.reset();
    BOOST_TEST(run(4, field, {}, open).measurements.empty());
    auto odd = bed();
    odd.periodic_x = length + 0.5;
    BOOST_TEST(run(4, field, {}, odd).measurements.empty());
    auto topless = bed();
    topless.plates.lid = std::monostate{};
    BOOST_TEST(run(4, field, {}, topless).measurements.empty());
    auto bottomless = bed();
    bottomless.plates.bottom.reset();
    measure::DisplacementSpectrum estimator(bottomless, {.spacing = h0});
    SyntheticFrame frame;
    estimator.add(frame.view());
    measure::Results results;
    estimator.finish(results);
    BOOST_TEST(results.measurements.empty());
}

BOOST_AUTO_TEST_CASE(refuses_options_that_make_no_sense) {
    for (const DisplacementSpectrumOptions& bad : {DisplacementSpectrumOptions{.spacing = 0},
                                                   {.spacing = -1},
                                                   {.spacing = std::nan("")},
                                                   {.spacing = h0, .k_min = 0},
                                                   {.spacing = h0, .k_min = 16},
                                                   {.spacing = h0, .tail_min = 32},
                                                   {.spacing = h0, .groups = {}},
                                                   {.spacing = h0, .groups = {{0, 5}}},
                                                   {.spacing = h0, .groups = {{6, 5}}}}) {
        BOOST_CHECK_THROW(measure::DisplacementSpectrum(bed(), bad), std::invalid_argument);
    }
}
