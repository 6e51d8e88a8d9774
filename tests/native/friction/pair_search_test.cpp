// The neighbour list has every pair that can touch within the margins, once, seen across the period
// from the right side, and no pair of frozen discs; against all pairs and images.
#include "native/base/errors.hpp"
#include "native/base/random.hpp"
#include "native/friction/pair_search.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace crossgrain;
using friction::PairSearch;

namespace {

struct Discs {
    std::vector<double> x, y, radius, margin_x, margin_y;
    std::size_t mobile = 0;
    [[nodiscard]] friction::DiscView view() const {
        return {.x = x,
                .y = y,
                .radius = radius,
                .margin_x = margin_x,
                .margin_y = margin_y,
                .mobile = mobile};
    }
    [[nodiscard]] double margin(const std::vector<double>& margins, std::size_t i) const {
        return i < mobile ? margins[i] : 0;
    }
};

/// Anywhere in a box of 40 x 30 and some periods beyond; one in eight has margins up to `widest`.
Discs random_discs(std::size_t mobile, std::size_t frozen, double widest) {
    Discs d{.x = {}, .y = {}, .radius = {}, .margin_x = {}, .margin_y = {}, .mobile = mobile};
    for (std::uint64_t i = 0; i < mobile + frozen; ++i) {
        const auto number = [&](std::uint64_t k) {
            return uniform(5, RandomStream::jitter, 8 * i + k);
        };
        d.x.push_back(40 * (3 * number(0) - 1));
        d.y.push_back(30 * (3 * number(1) - 1));
        d.radius.push_back(0.4 + 0.2 * number(2));
        if (i >= mobile) continue;
        const double reach = i % 8 == 0 ? widest : 0.2;
        d.margin_x.push_back(reach * number(3));
        d.margin_y.push_back(i % 3 == 0 ? d.margin_x.back() : reach * number(4));
    }
    return d;
}

using Seen = std::map<std::pair<std::size_t, std::size_t>, std::array<double, 2>>;

/// All pairs over all images, with the lower disc first.
Seen all_pairs(const Discs& d, std::optional<double> period_x, std::optional<double> period_y) {
    Seen seen;
    const auto gap = [](double distance, double margin) {
        return std::max(std::abs(distance) - margin, 0.0);
    };
    for (std::size_t i = 0; i < d.x.size(); ++i) {
        for (std::size_t j = i + 1; j < d.x.size(); ++j) {
            if (i >= d.mobile) continue;
            double dx = d.x[i] - d.x[j], dy = d.y[i] - d.y[j];
            if (period_x) dx = std::remainder(dx, *period_x);
            if (period_y) dy = std::remainder(dy, *period_y);
            const double across = gap(dx, d.margin(d.margin_x, i) + d.margin(d.margin_x, j));
            const double up = gap(dy, d.margin(d.margin_y, i) + d.margin(d.margin_y, j));
            const double reach = d.radius[i] + d.radius[j];
            if (across * across + up * up < reach * reach) seen[{i, j}] = {dx, dy};
        }
    }
    return seen;
}

void check(const Discs& d, std::optional<double> period_x, std::optional<double> period_y) {
    PairSearch search(period_x, period_y);
    search.find(d.view());
    auto expected = all_pairs(d, period_x, period_y);
    BOOST_TEST(!expected.empty());
    auto sorted = search.order();
    for (std::size_t place = 0; place < sorted.size(); ++place)
        BOOST_TEST((sorted[place] < d.mobile) == (place < d.mobile));
    for (const auto& pair : search.pairs()) {
        BOOST_TEST(pair.i < d.mobile);
        const std::size_t i = search.order()[pair.i], j = search.order()[pair.j];
        const auto found = expected.find(std::minmax(i, j));
        BOOST_TEST_REQUIRE((found != expected.end()));
        const double sign = i < j ? 1 : -1;
        BOOST_TEST(std::abs(d.x[i] - d.x[j] + pair.shift_x - sign * found->second[0]) < 1e-12);
        BOOST_TEST(std::abs(d.y[i] - d.y[j] + pair.shift_y - sign * found->second[1]) < 1e-12);
        expected.erase(found);
    }
    BOOST_TEST(expected.empty());
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t k = 0; k < sorted.size(); ++k)
        BOOST_TEST(sorted[k] == k);
}

}  // namespace

BOOST_AUTO_TEST_CASE(it_finds_all_pairs_once) {
    for (const double widest : {0.3, 4.0}) {
        const auto discs = random_discs(400, 150, widest);
        check(discs, {}, {});
        check(discs, 40.0, {});
        check(discs, {}, 30.0);
        check(discs, 40.0, 30.0);
    }
}

BOOST_AUTO_TEST_CASE(it_finds_all_pairs_in_the_smallest_periods) {
    auto discs = random_discs(9, 3, 0.1);
    const PairSearch search(3.0, 3.0);
    const double widest = search.widest_margin(0.6);
    for (auto* margins : {&discs.margin_x, &discs.margin_y}) {
        for (double& margin : *margins)
            margin = std::min(margin, widest);
    }
    check(discs, 3.0, 3.0);
}

BOOST_AUTO_TEST_CASE(it_finds_nothing_where_there_is_nothing) {
    PairSearch search({}, {});
    search.find({});
    BOOST_TEST(search.pairs().empty());
    auto discs = random_discs(0, 50, 1);
    search.find(discs.view());
    BOOST_TEST(search.pairs().empty());
}

BOOST_AUTO_TEST_CASE(it_refuses_what_is_no_position_and_periods_too_short) {
    auto discs = random_discs(20, 0, 1);
    PairSearch search({}, {});
    discs.x[7] = std::numeric_limits<double>::quiet_NaN();
    BOOST_CHECK_THROW(search.find(discs.view()), TrajectoryError);
    discs.x[7] = 1e12;
    BOOST_CHECK_THROW(search.find(discs.view()), TrajectoryError);
    BOOST_CHECK_THROW((void)PairSearch(2.0, {}).widest_margin(0.5), std::invalid_argument);
    BOOST_TEST(PairSearch({}, 3.0).widest_margin(0.5) == 0.25);
}
