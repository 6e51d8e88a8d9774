// Replicas of known scatter, and what must not be combined.
#include "reference/compare/replicas.hpp"

#include "native/base/random.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::compare;
using measure::Measurement;

namespace {

Measurement slope(double value, double error) {
    return {.observable = "slope_1_5",
            .value = value,
            .standard_error = error,
            .systematic = 0.2,
            .n = 17,
            .settings = {{"k_min", 1}, {"vectors", 17}}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(four_replicas_are_judged_by_their_scatter) {
    std::vector<Measurement> replicas{slope(1, 9), slope(2, 9), slope(3, 9), slope(6, 9)};
    replicas[2].settings["vectors"] = 16;
    replicas[3].settings["k_min"] = 1 + 1e-14;  // an angle fitted to a wall
    const auto combined = combine(replicas);
    BOOST_TEST(combined.measurement.value == 3, tt::tolerance(1e-14));
    // s^2 = (4 + 1 + 0 + 9)/3, error = s/2.
    BOOST_TEST(combined.measurement.standard_error == std::sqrt(14.0 / 3) / 2,
               tt::tolerance(1e-14));
    BOOST_TEST((combined.basis == ErrorBasis::scatter));
    BOOST_TEST(combined.degrees_of_freedom == 3);
    BOOST_TEST(combined.measurement.n == 68);
    BOOST_TEST(combined.measurement.systematic == 0.2, tt::tolerance(1e-14));
    BOOST_TEST(combined.measurement.settings.size() == 1);
    BOOST_TEST(combined.measurement.settings.at("k_min") == 1);
    BOOST_TEST(combined.replicas == 4);
}

BOOST_AUTO_TEST_CASE(few_replicas_are_judged_by_their_own_errors) {
    const std::vector<Measurement> replicas{slope(1, 0.3), slope(1.1, 0.4)};
    const auto combined = combine(replicas);
    BOOST_TEST(combined.measurement.value == 1.05, tt::tolerance(1e-14));
    BOOST_TEST(combined.measurement.standard_error == 0.25, tt::tolerance(1e-14));
    BOOST_TEST((combined.basis == ErrorBasis::within_run));
    BOOST_TEST(combined.degrees_of_freedom == 32);
    const auto single = combine(std::span(replicas).first(1));
    BOOST_TEST(single.measurement.standard_error == 0.3, tt::tolerance(1e-14));
    BOOST_TEST(single.degrees_of_freedom == 16);
}

BOOST_AUTO_TEST_CASE(differing_numbers_are_never_called_exact) {
    const std::vector<Measurement> replicas{slope(1, 0), slope(2, 0)};
    const auto combined = combine(replicas);
    BOOST_TEST((combined.basis == ErrorBasis::scatter));
    BOOST_TEST(combined.measurement.standard_error == 0.5, tt::tolerance(1e-14));
    BOOST_TEST(combined.degrees_of_freedom == 1);
}

BOOST_AUTO_TEST_CASE(equal_exact_numbers_stay_exact) {
    const std::vector<Measurement> replicas{slope(0.1, 0), slope(0.1, 0), slope(0.1, 0)};
    const auto combined = combine(replicas);
    BOOST_TEST(combined.measurement.value == 0.1);
    BOOST_TEST(combined.measurement.standard_error == 0);
    BOOST_TEST(std::isinf(combined.degrees_of_freedom));
}

BOOST_AUTO_TEST_CASE(error_is_the_scatter_of_repeated_combinations) {
    constexpr std::uint64_t repeats = 10000, n = 6;
    double squares = 0, stated = 0;
    for (std::uint64_t r = 0; r < repeats; ++r) {
        std::vector<Measurement> replicas;
        for (std::uint64_t i = 0; i < n; ++i) {
            const double noise = normal_pair(8, RandomStream::jitter, r * n + i)[0];
            replicas.push_back(slope(-1.6 + 0.1 * noise, 0.01));
        }
        const auto combined = combine(replicas).measurement;
        squares += std::pow(combined.value + 1.6, 2) / repeats;
        stated += std::pow(combined.standard_error, 2) / repeats;
    }
    // 10000 repeats know a variance to 1.4 %: four of those.
    BOOST_TEST(squares == stated, tt::tolerance(0.06));
}

BOOST_AUTO_TEST_CASE(refuses_what_is_not_one_observable) {
    const auto refuse = [](const std::vector<Measurement>& replicas) {
        BOOST_CHECK_THROW(static_cast<void>(combine(replicas)), std::invalid_argument);
    };
    refuse({});
    auto other = slope(1, 0.1);
    other.observable += "_tail";
    refuse({slope(1, 0.1), other});
    other = slope(1, 0.1);
    other.unit += "/t";
    refuse({slope(1, 0.1), other});
    refuse({slope(std::nan(""), 0.1)});
    refuse({slope(1, std::nan(""))});
    refuse({slope(1, -0.1)});
}
