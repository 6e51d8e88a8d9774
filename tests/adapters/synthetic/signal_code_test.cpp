// The signals that calibrate estimators are what they claim: their variance, their correlations and
// their wave, judged without any of the estimators.
#include "adapters/synthetic/coloured_noise.hpp"
#include "adapters/synthetic/signal_code.hpp"
#include "native/base/errors.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <stdexcept>
#include <vector>

using namespace crossgrain;

namespace {

scene::SyntheticSignal signal() {
    scene::SyntheticSignal s;
    s.sampling = {.length = 40,
                  .width = 3,
                  .bin = 10,
                  .replicas = 3,
                  .burn_in = 70,
                  .steps = 5000,
                  .every = 10,
                  .fields = {}};
    s.mean = 1000;
    s.noise = 50;
    s.exponent = 1;
    s.seed = 4;
    return s;
}

adapters::RunOptions options() {
    return {.directory = std::filesystem::temp_directory_path(),
            .time_limit = 60,
            .stop = {},
            .keep_dump = false};
}

/// Counts of all frames, shape (frames, bins, replicas).
std::vector<std::uint16_t> run(const scene::SyntheticSignal& s) {
    std::vector<std::uint16_t> counts;
    const adapters::SyntheticSignalCode code("test");
    std::int64_t step = s.sampling.burn_in;
    (void)code.run(s, options(), [&](const scene::GasFrame& frame) {
        BOOST_TEST(frame.step == step);
        BOOST_TEST(frame.bins == static_cast<std::size_t>(s.sampling.bins()));
        BOOST_TEST(frame.replicas == static_cast<std::size_t>(s.sampling.replicas));
        BOOST_TEST(frame.rests.empty());
        step += s.sampling.every;
        counts.insert(counts.end(), frame.count.begin(), frame.count.end());
    });
    BOOST_TEST(counts.size() == static_cast<std::size_t>(s.sampling.frames()) * 4 *
                                    static_cast<std::size_t>(s.sampling.replicas));
    return counts;
}

/// Mean over many series of (x(t) - x(t + lag))^2 / 2, with series of variance 1.
double structure(double exponent, std::size_t lag) {
    constexpr std::size_t length = 1024, series = 200;
    adapters::ColouredNoise noise(length, exponent, 1);
    double sum = 0;
    for (std::uint64_t s = 0; s < series; ++s) {
        const auto x = noise.series(3, s);
        for (std::size_t t = 0; t + lag < length; ++t)
            sum += (x[t] - x[t + lag]) * (x[t] - x[t + lag]) / 2;
    }
    return sum / static_cast<double>(series * (length - lag));
}

/// The same from the definition: sum over the frequencies of a period of 2048 points.
double exact_structure(double exponent, std::size_t lag) {
    double variance = 0, sum = 0;
    for (std::size_t k = 1; k <= 1024; ++k) {
        const double weight = std::pow(static_cast<double>(k), -exponent) * (k < 1024 ? 4.0 : 1.0);
        variance += weight;
        sum += weight * (1 - std::cos(2 * std::numbers::pi * static_cast<double>(k * lag) / 2048));
    }
    return sum / variance;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_noise_has_the_correlations_of_its_spectrum) {
    for (const double exponent : {0.0, 0.5, 1.0, 1.33, 1.86}) {
        for (const std::size_t lag : {1U, 4U, 32U, 256U}) {
            const double exact = exact_structure(exponent, lag);
            // 200 series; the slowest noise has the fewest independent samples.
            BOOST_TEST(std::abs(structure(exponent, lag) / exact - 1) < 0.08);
        }
    }
}

BOOST_AUTO_TEST_CASE(white_noise_has_its_deviation_and_no_memory) {
    auto s = signal();
    s.exponent = 0;
    const auto counts = run(s);
    double sum = 0, squares = 0, neighbours = 0;
    const auto n = static_cast<double>(counts.size());
    for (std::size_t j = 0; j < counts.size(); ++j) {
        const double d = counts[j] - 1000.0;
        sum += d;
        squares += d * d;
        if (j >= 12) neighbours += d * (counts[j - 12] - 1000.0);  // the frame before
    }
    BOOST_TEST(std::abs(sum / n) < 4 * 50 / std::sqrt(n));
    BOOST_TEST(std::abs(squares / n / 2500 - 1) < 0.08);
    BOOST_TEST(std::abs(neighbours / squares) < 4 / std::sqrt(n));
}

BOOST_AUTO_TEST_CASE(the_wave_is_where_it_should_be) {
    auto s = signal();
    s.noise = 1e-9;
    s.wave_amplitude = 100;
    s.wave_velocity = 0.36;
    s.wave_number = 2;
    const auto counts = run(s);
    for (const std::size_t frame : {0U, 1U, 123U, 500U}) {
        for (std::size_t bin = 0; bin < 4; ++bin) {
            const double t = 70 + 10.0 * static_cast<double>(frame);
            const double x = 10 * static_cast<double>(bin) + 5;
            const double exact =
                1000 + 100 * std::cos(2 * std::numbers::pi * 2 * (x - 0.36 * t) / 40);
            for (std::size_t r = 0; r < 3; ++r)
                BOOST_TEST(std::abs(counts[(frame * 4 + bin) * 3 + r] - exact) <= 0.51);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_replica_does_not_depend_on_how_many_there_are) {
    const auto three = run(signal());
    auto s = signal();
    s.sampling.replicas = 1;
    const auto one = run(s);
    bool same = true;
    for (std::size_t j = 0; j < one.size(); ++j)
        same = same && one[j] == three[3 * j];
    BOOST_TEST(same);
    BOOST_TEST((run(signal()) == three));
    s = signal();
    s.seed = 5;
    BOOST_TEST((run(s) != three));
}

BOOST_AUTO_TEST_CASE(a_signal_beyond_the_bound_of_memory_is_not_expressible) {
    const adapters::SyntheticSignalCode code("test");
    auto s = signal();
    BOOST_TEST(!code.cannot_express(s).has_value());
    s.sampling.steps = std::int64_t{10} << 30;
    BOOST_TEST(code.cannot_express(s)->find("bytes") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_run_ends_when_asked_or_when_its_time_is_over) {
    const adapters::SyntheticSignalCode code("test");
    std::stop_source source;
    source.request_stop();
    auto o = options();
    o.stop = source.get_token();
    BOOST_CHECK_THROW((void)code.run(signal(), o, [](const scene::GasFrame&) {}), Interrupted);
    o = options();
    o.time_limit = 1e-9;
    BOOST_CHECK_THROW((void)code.run(signal(), o, [](const scene::GasFrame&) {}), AdapterError);
}
