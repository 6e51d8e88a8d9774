// Protects the attribution of a difference to single switches: additive data exactly, interactions
// shared out and reported, noise no contribution, and what is no data.
#include "reference/compare/attribution.hpp"

#include "native/base/random.hpp"

#include <boost/test/unit_test.hpp>

#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::compare;
using Settings = std::vector<std::vector<double>>;

namespace {

Settings settings(std::size_t switches, std::size_t replicas,
                  const std::function<double(std::size_t, std::size_t)>& value) {
    Settings values(std::size_t{1} << switches);
    for (std::size_t s = 0; s < values.size(); ++s) {
        for (std::size_t r = 0; r < replicas; ++r)
            values[s].push_back(value(s, r));
    }
    return values;
}

double turned(std::size_t setting, std::size_t which) {
    return (setting >> which & 1U) != 0 ? 1.0 : 0.0;
}

double noise(std::uint64_t seed, std::size_t setting, std::size_t replica) {
    return normal_pair(seed, RandomStream::signal, 1000 * setting + replica)[0];
}

}  // namespace

BOOST_AUTO_TEST_CASE(additive_effects_are_found_exactly_whatever_the_replicas_share) {
    const std::vector<double> effects{0.5, -0.25, 2, 0};
    const auto values = settings(4, 5, [&](std::size_t s, std::size_t r) {
        double value = 10 + noise(1, 0, r);  // the same in all settings: paired away
        for (std::size_t i = 0; i < 4; ++i)
            value += effects[i] * turned(s, i);
        return value;
    });
    const auto found = attribute(values);
    BOOST_TEST(found.difference.value == 2.25, tt::tolerance(1e-13));
    BOOST_TEST(found.difference.standard_error < 1e-14);
    BOOST_TEST(found.a.standard_error > 0.1);
    BOOST_TEST(found.significant);
    for (std::size_t i = 0; i < 4; ++i) {
        for (const auto& mean : {found.contributions[i].average, found.contributions[i].first,
                                 found.contributions[i].last}) {
            BOOST_TEST(std::abs(mean.value - effects[i]) < 1e-13);
            BOOST_TEST(mean.standard_error < 1e-13);
        }
    }
    BOOST_TEST(std::abs(found.interaction.value) < 1e-13);
}

BOOST_AUTO_TEST_CASE(an_interaction_goes_half_and_half_and_is_reported) {
    const auto values = settings(
        3, 4, [](std::size_t s, std::size_t) { return 1 + 3 * turned(s, 0) * turned(s, 2); });
    const auto found = attribute(values);
    BOOST_TEST(found.contributions[0].average.value == 1.5, tt::tolerance(1e-14));
    BOOST_TEST(std::abs(found.contributions[1].average.value) < 1e-14);
    BOOST_TEST(found.contributions[2].average.value == 1.5, tt::tolerance(1e-14));
    BOOST_TEST(found.contributions[0].first.value == 0);
    BOOST_TEST(found.contributions[0].last.value == 3);
    BOOST_TEST(found.interaction.value == 3);
}

/// Three switches that act only together: a third each.
BOOST_AUTO_TEST_CASE(what_only_all_make_together_is_shared_by_all) {
    const auto values = settings(3, 2, [](std::size_t s, std::size_t) { return s == 7 ? 6.0 : 0; });
    const auto found = attribute(values);
    for (const auto& c : found.contributions)
        BOOST_TEST(c.average.value == 2, tt::tolerance(1e-14));
    BOOST_TEST(found.interaction.value == 6);
}

BOOST_AUTO_TEST_CASE(contributions_add_up_to_the_difference) {
    const auto found = attribute(settings(
        4, 6, [](std::size_t s, std::size_t r) { return noise(3, s, r) + (s == 5 ? 2 : 0); }));
    double sum = 0;
    for (const auto& c : found.contributions)
        sum += c.average.value;
    BOOST_TEST(sum == found.difference.value, tt::tolerance(1e-12));
}

/// 400 attributions of nothing but noise: one in twenty may claim a contribution, and the errors
/// stated are those that are seen. With the right error z^2 averages to the variance of Student's
/// t, 15/13, whose own error over 1200 (correlated) samples is below 0.1.
BOOST_AUTO_TEST_CASE(noise_contributes_nothing) {
    int claims = 0;
    double squares = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const auto found = attribute(
            settings(3, 16, [&](std::size_t s, std::size_t r) { return noise(seed + 10, s, r); }));
        bool any = false;
        for (const auto& c : found.contributions) {
            any = any || c.significant;
            const double z = c.average.value / c.average.standard_error;
            squares += z * z / 1200;
        }
        claims += any ? 1 : 0;
    }
    BOOST_TEST(claims > 4);
    BOOST_TEST(claims < 36);  // 20 +- 4.4
    BOOST_TEST(squares > 0.95);
    BOOST_TEST(squares < 1.4);
}

BOOST_AUTO_TEST_CASE(an_effect_within_noise_is_given_to_its_switch) {
    const auto found = attribute(settings(
        3, 16, [](std::size_t s, std::size_t r) { return 2 * turned(s, 1) + noise(7, s, r); }));
    BOOST_TEST(found.contributions[1].significant);
    BOOST_TEST(!found.contributions[0].significant);
    BOOST_TEST(!found.contributions[2].significant);
    BOOST_TEST(std::abs(found.contributions[1].average.value - 2) <
               4 * found.contributions[1].average.standard_error);
}

BOOST_AUTO_TEST_CASE(refuses_what_is_no_full_set_of_settings) {
    const auto one = [](std::size_t, std::size_t) { return 1.0; };
    BOOST_CHECK_THROW((void)attribute(Settings{}), std::invalid_argument);
    BOOST_CHECK_THROW((void)attribute(Settings{{1, 2}}), std::invalid_argument);
    BOOST_CHECK_THROW((void)attribute(Settings{{1, 2}, {1, 2}, {1, 2}}), std::invalid_argument);
    BOOST_CHECK_THROW((void)attribute(settings(2, 1, one)), std::invalid_argument);
    auto uneven = settings(2, 3, one);
    uneven[3].pop_back();
    BOOST_CHECK_THROW((void)attribute(uneven), std::invalid_argument);
    auto endless = settings(2, 3, one);
    endless[1][1] = std::numeric_limits<double>::infinity();
    BOOST_CHECK_THROW((void)attribute(endless), std::invalid_argument);
}
