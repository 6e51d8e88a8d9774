// Protects the regression judge: a value that leaves the band of the earlier ones is seen, one that
// scatters within its error is not.
#include "reports/studies/history.hpp"

#include <boost/test/unit_test.hpp>

using namespace crossgrain;
using studies::Drift;

namespace {

std::vector<store::HistoryPoint> points(const std::string& observable,
                                        const std::vector<double>& values, double error) {
    std::vector<store::HistoryPoint> result;
    for (const double value : values) {
        result.push_back({.case_name = "c",
                          .code = "native-dem",
                          .observable = observable,
                          .settings_json = "{}",
                          .seed = 1,
                          .value = value,
                          .standard_error = error});
    }
    return result;
}

studies::Drift drift(const std::string& observable, const std::vector<double>& values,
                     double error) {
    return studies::history_of(points(observable, values, error)).at(0).drift;
}

}  // namespace

BOOST_AUTO_TEST_CASE(one_earlier_value_is_too_few_to_judge) {
    BOOST_CHECK(drift("slope", {1}, 0.1) == studies::Drift::too_few);
    BOOST_CHECK(drift("slope", {1, 5}, 0.1) == studies::Drift::too_few);
}

BOOST_AUTO_TEST_CASE(a_value_beyond_its_error_leaves_the_band) {
    BOOST_CHECK(drift("slope", {1.0, 1.1, 1.25}, 0.1) == studies::Drift::in_band);
    BOOST_CHECK(drift("slope", {1.0, 1.1, 1.35}, 0.1) == studies::Drift::left_band);
    BOOST_CHECK(drift("slope", {1.0, 1.1, 0.7}, 0.1) == studies::Drift::left_band);
}

BOOST_AUTO_TEST_CASE(round_off_is_no_drift_but_a_change_without_error_is) {
    BOOST_CHECK(drift("momentum_drift_x", {1e-15, 2e-15, 9e-15}, 0) == studies::Drift::in_band);
    BOOST_CHECK(drift("restitution", {0.8, 0.8, 0.8001}, 0) == studies::Drift::left_band);
}

BOOST_AUTO_TEST_CASE(a_cost_may_scatter_but_not_double) {
    BOOST_CHECK(drift("cpu_s", {10, 11, 12.5}, 0) == studies::Drift::in_band);
    BOOST_CHECK(drift("cpu_s", {10, 11, 22}, 0) == studies::Drift::left_band);
    BOOST_CHECK(drift("cpu_s", {0.01, 0.01, 0.1}, 0) == studies::Drift::in_band);
}

BOOST_AUTO_TEST_CASE(other_settings_are_another_series) {
    auto all = points("slope", {1, 1, 1}, 0.01);
    all[2].settings_json = "{\"dt\":2}";
    all[2].value = 3;
    const auto history = studies::history_of(all);
    BOOST_TEST(history.size() == 2U);
    for (const auto& series : history)
        BOOST_CHECK(series.drift == studies::Drift::too_few);
}
