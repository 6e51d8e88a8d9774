// Speed against accuracy: start-up, the front, and how many runs are enough.
#include "native/base/errors.hpp"
#include "reports/studies/chart/advise.hpp"
#include "reports/studies/chart/chart.hpp"
#include "reports/studies/chart/chart_document.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

using namespace crossgrain;
using studies::ChartPoint;
namespace tt = boost::test_tools;

namespace {

studies::ChartPoint point(const std::string& variant, double cpu_s, double bias, double scatter,
                          double bias_stderr = 0) {
    studies::ChartPoint p{.code = "native-dem", .variant = variant, .runs = 8, .cpu_s = cpu_s};
    p.value = 1 + bias;
    p.bias = bias;
    p.bias_stderr = bias_stderr;
    p.scatter = scatter;
    p.error = std::hypot(bias, scatter);
    return p;
}

}  // namespace

BOOST_AUTO_TEST_CASE(start_up_is_where_the_line_meets_no_work) {
    BOOST_TEST(studies::start_up({{1e6, 1.5}, {2e6, 2.5}, {4e6, 4.5}}) == 0.5,
               tt::tolerance(1e-12));
    // Nothing is known of runs of one length, and no code starts in negative time.
    BOOST_TEST(studies::start_up({{1e6, 1.5}, {1e6, 1.6}}) == 0.0);
    BOOST_TEST(studies::start_up({{1e6, 1.0}, {2e6, 3.0}}) == 0.0);
    BOOST_TEST(studies::start_up({}) == 0.0);
}

BOOST_AUTO_TEST_CASE(the_front_is_what_nothing_cheaper_beats) {
    std::vector<studies::ChartPoint> points{point("slow", 4, 0.01, 0), point("fast", 1, 0.1, 0),
                                            point("beaten", 2, 0.2, 0),
                                            point("dropped", 0.5, 0.001, 0)};
    points.back().drops = "spins";
    studies::mark_front(points);
    BOOST_TEST(points[0].variant == "dropped");
    BOOST_TEST(!points[0].on_front);  // it leaves physics out: another question
    BOOST_TEST(points[1].on_front);
    BOOST_TEST(!points[2].on_front);
    BOOST_TEST(points[3].on_front);
}

BOOST_AUTO_TEST_CASE(runs_average_scatter_away_but_no_bias) {
    // (0.1 - 0.05)/1.96 = 0.0255: a scatter of 0.1 needs 15.4 runs.
    BOOST_TEST(studies::runs_needed(point("a", 1, 0.05, 0.1), 0.1).value() == 16);
    BOOST_TEST(studies::runs_needed(point("a", 1, 0.05, 0.0), 0.1).value() == 1);
    BOOST_TEST(!studies::runs_needed(point("a", 1, 0.12, 0.0), 0.1).has_value());
    // The bias is not known well enough to promise anything.
    BOOST_TEST(!studies::runs_needed(point("a", 1, 0.05, 0.0, 0.03), 0.1).has_value());
}

BOOST_AUTO_TEST_CASE(the_cheapest_way_counts_its_runs) {
    studies::ChartedObservable charted{.observable = "slope", .margin = 1};
    charted.points = {point("wrong", 0.1, 0.5, 0), point("noisy", 1, 0, 0.2),
                      point("fine", 5, 0, 0.01)};
    studies::mark_front(charted.points);
    const auto advice = studies::advise(charted, 0.1);
    BOOST_TEST_REQUIRE(advice.cheapest.has_value());
    // noisy needs 16 runs of 1 s, fine one of 5 s.
    BOOST_TEST(advice.cheapest->point.variant == "fine");
    BOOST_TEST(advice.cheapest->runs == 1);
    BOOST_TEST_REQUIRE(advice.next_cheaper.has_value());
    BOOST_TEST(advice.next_cheaper->point.variant == "wrong");
    BOOST_TEST(advice.next_cheaper->wrong);
    // A noisy way is enough for any tolerance, at a price.
    BOOST_TEST(studies::advise(charted, 1e-3).cheapest->point.variant == "fine");
    charted.points = {point("wrong", 0.1, 0.5, 0), point("unsure", 1, 0, 0, 0.1)};
    BOOST_TEST(!studies::advise(charted, 1e-3).cheapest.has_value());
    BOOST_TEST(!studies::advise(charted, 1e-3).reason.empty());
}

BOOST_AUTO_TEST_CASE(dropped_physics_is_judged_against_the_full_variant) {
    studies::ChartedObservable charted{.observable = "slope", .margin = 1};
    charted.points = {point("full", 2, 0, 0.02), point("without", 1, 0.01, 0.02),
                      point("wrongly", 1, 0.4, 0.02)};
    charted.points[1].drops = "lid";
    charted.points[2].drops = "friction";
    const auto advice = studies::advise(charted, 0.1);
    BOOST_TEST_REQUIRE(advice.dropped.size() == 2U);
    BOOST_TEST(advice.dropped[0].verdict == "agree");
    BOOST_TEST(advice.dropped[0].cost_ratio == 0.5, tt::tolerance(1e-12));
    BOOST_TEST(advice.dropped[1].verdict == "disagree");
    BOOST_TEST(advice.cheapest->point.variant == "full");
}

// The page shows all charts of a store, whichever call made them; what lies there and is no chart
// is named, not drawn as nothing.
BOOST_AUTO_TEST_CASE(earlier_charts_stay_on_the_page) {
    const tests::TemporaryDirectory directory;
    const auto write = [&](const char* name, const char* text) {
        std::ofstream(directory.path() / name) << text;
    };
    write("first.json", R"({"case": "first", "title": "old"})");
    write("second.json", R"({"case": "second", "title": "old"})");
    write("second.csv", "case,observable");
    auto charts = nlohmann::json::parse(R"([{"case": "second", "title": "new"}])");
    studies::add_earlier_charts(directory.path(), charts);
    BOOST_TEST_REQUIRE(charts.size() == 2U);
    BOOST_TEST(charts[0].at("title").get<std::string>() == "new");
    BOOST_TEST(charts[1].at("case").get<std::string>() == "first");
    write("third.json", R"({"case": )");
    BOOST_CHECK_THROW(studies::add_earlier_charts(directory.path(), charts), CaseError);
}
