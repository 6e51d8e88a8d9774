// The cell search against the plain double loop, for open and periodic boxes of all shapes.
#include "cases/scene/contact_search.hpp"

#include "cases/scene/scene.hpp"
#include "native/base/random.hpp"

#include <boost/test/unit_test.hpp>

#include <chrono>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;

namespace {

using Pairs = std::set<std::pair<std::size_t, std::size_t>>;
using Period = std::optional<double>;

struct Points {
    std::vector<double> x, y;
};

Points random_points(std::size_t n, double width, double height, std::uint64_t seed) {
    Points points;
    for (std::size_t i = 0; i < n; ++i) {
        points.x.push_back(width * (uniform(seed, RandomStream::jitter, 2 * i) - 0.3));
        points.y.push_back(height * (uniform(seed, RandomStream::jitter, 2 * i + 1) - 0.6));
    }
    return points;
}

Pairs direct(const Points& p, double d, const Period& px, const Period& py) {
    Pairs pairs;
    for (std::size_t i = 0; i < p.x.size(); ++i) {
        for (std::size_t j = i + 1; j < p.x.size(); ++j) {
            const double dx = scene::nearest_image(p.x[i] - p.x[j], px);
            const double dy = scene::nearest_image(p.y[i] - p.y[j], py);
            if (dx * dx + dy * dy < d * d) pairs.emplace(i, j);
        }
    }
    return pairs;
}

}  // namespace

BOOST_AUTO_TEST_CASE(finds_what_the_double_loop_finds_once) {
    std::uint64_t seed = 0;
    for (const auto& [n, width, height] : {std::tuple{300, 40.0, 30.0},
                                           {300, 200.0, 3.0},
                                           {2, 3.0, 3.0},
                                           {50, 1e4, 1e4},
                                           {1, 1.0, 1.0},
                                           {400, 6.5, 90.0}}) {
        for (const Period& px : {Period{}, Period{width * 0.8}, Period{5.9}, Period{6.0}}) {
            for (const Period& py : {Period{}, Period{height * 0.7}}) {
                const auto points =
                    random_points(static_cast<std::size_t>(n), width, height, ++seed);
                scene::ContactSearch search(2.0, px, py);
                const auto contacts = search.find(points.x, points.y);
                Pairs found;
                for (const auto& c : contacts)
                    found.emplace(c.i, c.j);
                BOOST_TEST(found.size() == contacts.size());
                BOOST_TEST((found == direct(points, 2.0, px, py)));
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(normal_points_from_the_second_to_the_first_over_the_boundary) {
    scene::ContactSearch search(2.0, 20.0, std::nullopt);
    const std::vector<double> x{-9.5, 49.5}, y{1, 0};  // 49.5 is the image of 9.5
    const auto contacts = search.find(x, y);
    BOOST_TEST_REQUIRE(contacts.size() == 1U);
    BOOST_TEST(contacts[0].distance == std::sqrt(2.0), tt::tolerance(1e-14));
    BOOST_TEST(contacts[0].nx == std::sqrt(0.5), tt::tolerance(1e-14));
    BOOST_TEST(contacts[0].ny == std::sqrt(0.5), tt::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(grains_at_rest_length_or_at_one_place) {
    scene::ContactSearch search(2.0, std::nullopt, std::nullopt);
    BOOST_TEST(search.find(std::vector<double>{0, 2}, std::vector<double>{0, 0}).empty());
    const auto same = search.find(std::vector<double>{1, 1}, std::vector<double>{1, 1});
    BOOST_TEST_REQUIRE(same.size() == 1U);
    BOOST_TEST(same[0].distance == 0);
    BOOST_TEST(same[0].nx == 1);
    BOOST_TEST(search.find({}, {}).empty());
}

BOOST_AUTO_TEST_CASE(ten_thousand_grains_take_milliseconds) {
    const auto points = random_points(10000, 200.0, 200.0, 99);
    scene::ContactSearch search(2.0, 200.0, std::nullopt);
    const auto start = std::chrono::steady_clock::now();
    const auto count = search.find(points.x, points.y).size();
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    BOOST_TEST_MESSAGE(count << " contacts in " << spent.count() * 1e3 << " ms");
    // The double loop takes about 0.3 s; this is a matter of 3 ms, on a loaded machine more.
    BOOST_TEST(spent.count() < 0.1);
}
