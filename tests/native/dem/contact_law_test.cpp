// The six force laws as functions: Taguchi's formula, what is cut when the normal force turns
// attractive, and a dashpot that never gives energy.
#include "native/dem/contact_law.hpp"

#include "native/base/random.hpp"

#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>

namespace tt = boost::test_tools;
using namespace crossgrain;
using dem::AttractiveTail;
using dem::DampingDirection;
using dem::Force;
using dem::SpringDashpot;

namespace {

constexpr double k = 496, eta = 2.23;

using FullKept = SpringDashpot<DampingDirection::full_vector, AttractiveTail::kept>;
using FullCut = SpringDashpot<DampingDirection::full_vector, AttractiveTail::contact_force_cut>;
using FullNormalCut =
    SpringDashpot<DampingDirection::full_vector, AttractiveTail::normal_force_cut>;
using NormalKept = SpringDashpot<DampingDirection::normal_only, AttractiveTail::kept>;
using NormalCut = SpringDashpot<DampingDirection::normal_only, AttractiveTail::contact_force_cut>;
using NormalNormalCut =
    SpringDashpot<DampingDirection::normal_only, AttractiveTail::normal_force_cut>;
using AllLaws =
    boost::mpl::list<FullKept, FullCut, FullNormalCut, NormalKept, NormalCut, NormalNormalCut>;

/// A contact somewhere in the space of all contacts; about a third of them are attractive.
struct Contact {
    explicit Contact(std::uint64_t n)
        : overlap(0.1 * uniform(1, RandomStream::jitter, n)),
          angle(2 * std::numbers::pi * uniform(2, RandomStream::jitter, n)), nx(std::cos(angle)),
          ny(std::sin(angle)), vx(20 * normal_pair(3, RandomStream::jitter, n)[0]),
          vy(20 * normal_pair(3, RandomStream::jitter, n)[1]) {}
    template <class Law>
    [[nodiscard]] Force force(const Law& law) const {
        return law(overlap, nx, ny, vx, vy);
    }
    [[nodiscard]] double normal_speed() const { return vx * nx + vy * ny; }
    [[nodiscard]] double normal_force() const { return k * overlap - eta * normal_speed(); }

    double overlap, angle, nx, ny, vx, vy;
};

constexpr std::uint64_t contacts = 3000;
// Forces reach 150; some ten roundings of that size.
constexpr double rounding = 1e-12;

}  // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(a_contact_without_relative_velocity_is_a_spring, Law, AllLaws) {
    const Force force = Law{k, eta}(0.01, 0.6, 0.8, 0.0, 0.0);
    BOOST_TEST(force.x == 0.6 * (k * 0.01), tt::tolerance(1e-15));
    BOOST_TEST(force.y == 0.8 * (k * 0.01), tt::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(the_dashpot_never_gives_energy, Law, AllLaws) {
    for (std::uint64_t n = 0; n < contacts; ++n) {
        const Contact c(n);
        const Force f = c.force(Law{k, eta});
        const double spring = k * c.overlap;
        const double power = (f.x - spring * c.nx) * c.vx + (f.y - spring * c.ny) * c.vy;
        BOOST_TEST_REQUIRE(power <= rounding * 100);  // speeds reach 100
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(an_elastic_contact_is_the_spring_whatever_the_velocity, Law,
                              AllLaws) {
    for (std::uint64_t n = 0; n < contacts; ++n) {
        const Contact c(n);
        const Force f = c.force(Law{k, 0.0});
        BOOST_TEST_REQUIRE(std::hypot(f.x - k * c.overlap * c.nx, f.y - k * c.overlap * c.ny) <
                           rounding);
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(exchanging_the_grains_turns_the_force_round_bit_for_bit, Law,
                              AllLaws) {
    for (std::uint64_t n = 0; n < contacts; ++n) {
        const Contact c(n);
        const Force on_i = c.force(Law{k, eta});
        const Force on_j = Law{k, eta}(c.overlap, -c.nx, -c.ny, -c.vx, -c.vy);
        BOOST_TEST_REQUIRE(on_i.x == -on_j.x);
        BOOST_TEST_REQUIRE(on_i.y == -on_j.y);
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_cut_law_never_attracts_along_the_normal, Law, AllLaws) {
    const bool keeps_the_tail = std::is_same_v<Law, FullKept> || std::is_same_v<Law, NormalKept>;
    bool attracted = false;
    for (std::uint64_t n = 0; n < contacts; ++n) {
        const Contact c(n);
        const Force f = c.force(Law{k, eta});
        attracted = attracted || f.x * c.nx + f.y * c.ny < -rounding;
    }
    BOOST_TEST(attracted == keeps_the_tail);
}

BOOST_AUTO_TEST_CASE(the_full_vector_law_is_taguchi_s_equation_1) {
    for (std::uint64_t n = 0; n < contacts; ++n) {
        const Contact c(n);
        const Force f = c.force(FullKept{k, eta});
        BOOST_TEST_REQUIRE(std::abs(f.x - (k * c.overlap * c.nx - eta * c.vx)) < rounding);
        BOOST_TEST_REQUIRE(std::abs(f.y - (k * c.overlap * c.ny - eta * c.vy)) < rounding);
    }
}

BOOST_AUTO_TEST_CASE(the_normal_law_has_no_part_along_the_tangent) {
    for (std::uint64_t n = 0; n < contacts; ++n) {
        const Contact c(n);
        const Force f = c.force(NormalKept{k, eta});
        BOOST_TEST_REQUIRE(std::abs(f.y * c.nx - f.x * c.ny) < rounding);
        BOOST_TEST_REQUIRE(std::abs(f.x * c.nx + f.y * c.ny - c.normal_force()) < rounding);
    }
}

BOOST_AUTO_TEST_CASE(variants_differ_in_the_attractive_tail_only) {
    int attractive = 0;
    for (std::uint64_t n = 0; n < contacts; ++n) {
        const Contact c(n);
        const Force kept = c.force(FullKept{k, eta});
        const Force cut = c.force(FullCut{k, eta});
        const Force normal_cut = c.force(FullNormalCut{k, eta});
        if (c.normal_force() >= rounding) {
            BOOST_TEST_REQUIRE((cut.x == kept.x && cut.y == kept.y));
            BOOST_TEST_REQUIRE((normal_cut.x == kept.x && normal_cut.y == kept.y));
        } else if (c.normal_force() < -rounding) {
            ++attractive;
            BOOST_TEST_REQUIRE((cut.x == 0 && cut.y == 0));
            // What is left is the dashpot along the tangent.
            const double tangential = eta * (c.vy * c.nx - c.vx * c.ny);
            BOOST_TEST_REQUIRE(std::abs(normal_cut.x - tangential * c.ny) < rounding);
            BOOST_TEST_REQUIRE(std::abs(normal_cut.y + tangential * c.nx) < rounding);
        }
    }
    BOOST_TEST(attractive > 100);  // the question was asked
}

BOOST_AUTO_TEST_CASE(both_cuts_are_the_same_for_the_normal_law) {
    for (std::uint64_t n = 0; n < contacts; ++n) {
        const Contact c(n);
        const Force a = c.force(NormalCut{k, eta});
        const Force b = c.force(NormalNormalCut{k, eta});
        BOOST_TEST_REQUIRE(a.x == b.x);
        BOOST_TEST_REQUIRE(a.y == b.y);
    }
}
