// A lattice whose rows are slid by hand.
#include "cases/measure/bed/lattice_order.hpp"
#include "tests/cases/measure/synthetic_frame.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

constexpr int columns = 8, rows = 3;

/// Rows at distance 0.97 of the closest packing, so that they touch; the top row slid by `shift`.
SyntheticFrame slid(double time, double shift) {
    SyntheticFrame frame{.time = time};
    for (int i = 0; i < columns * rows; ++i) {
        const int row = i / columns;
        const double x = 2.0 * (i % columns) + row % 2 + (row == rows - 1 ? shift : 0.0);
        frame.add_grain(x, 0.97 * std::numbers::sqrt3 * row, 0, 0);
    }
    return frame;
}

measure::Results run(const std::vector<double>& shifts) {
    auto scene = plain_scene(columns * rows);
    scene.periodic_x = 2.0 * columns;
    measure::LatticeOrder estimator(scene);
    double time = 0;
    for (const double shift : shifts) {
        estimator.add(slid(time, shift).view());
        time += 0.5;
    }
    measure::Results results;
    estimator.finish(results);
    return results;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_lattice_that_only_trembles_is_kept) {
    const auto results = run({0, 0.1, -0.1, 0.2});
    BOOST_TEST(get(results, "foreign_contacts").value == 0);
    BOOST_TEST(get(results, "lattice_kept_until").value == 1.5);
}

BOOST_AUTO_TEST_CASE(a_row_that_slides_by_a_grain_meets_strangers) {
    // By a whole diameter every grain of the row loses one neighbour below and gains another.
    const auto results = run({0, 0.1, 2.0, 0.0});
    BOOST_TEST(get(results, "foreign_contacts").value == columns);
    BOOST_TEST(get(results, "lattice_kept_until").value == 0.5);
}

BOOST_AUTO_TEST_CASE(without_a_frame_nothing_is_said) {
    BOOST_TEST(run({}).measurements.empty());
}
