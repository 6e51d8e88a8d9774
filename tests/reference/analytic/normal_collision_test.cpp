// The closed forms against numbers known from elsewhere, limits, and a numerical integration that
// shares nothing with them.
#include "reference/analytic/normal_collision.hpp"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace tt = boost::test_tools;
using namespace crossgrain::analytic;

namespace {

// k0 and eta of Taguchi's bed: e = 0.8, t_col = 0.1, two grains of mass 1.
constexpr NormalContact bed{495.96987227912376, 2.2314355131420975, 0.5};

struct Integrated {
    double restitution, force_time, contact_time;
};

// mu delta'' = -max(0, k delta + eta delta') (cut) or without the maximum (kept), classical
// Runge-Kutta in small steps; the events by linear interpolation within a step.
Integrated integrate(const NormalContact& c, bool cut) {
    using State = std::array<double, 2>;
    bool dropped = false;
    const auto rate = [&](const State& s) -> State {
        const double force = c.stiffness * s[0] + c.damping * s[1];
        return {s[1], dropped ? 0.0 : -force / c.reduced_mass};
    };
    const auto moved = [](const State& s, const State& r, double h) -> State {
        return {s[0] + h * r[0], s[1] + h * r[1]};
    };
    const double h = std::sqrt(c.reduced_mass / c.stiffness) * 1e-5;
    State s{0.0, 1.0};
    double t = 0, force_time = 0;
    while (true) {
        const State k1 = rate(s), k2 = rate(moved(s, k1, h / 2)), k3 = rate(moved(s, k2, h / 2)),
                    k4 = rate(moved(s, k3, h));
        State next = s;
        for (std::size_t i = 0; i < 2; ++i) {
            next[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
        }
        const double before = c.stiffness * s[0] + c.damping * s[1];
        const double after = c.stiffness * next[0] + c.damping * next[1];
        if (cut && !dropped && after <= 0) {
            dropped = true;
            force_time = t + h * before / (before - after);
        }
        if (next[0] <= 0) {
            const double part = s[0] / (s[0] - next[0]);
            const double end = t + part * h;
            return {-(s[1] + part * (next[1] - s[1])), cut ? force_time : end, end};
        }
        s = next;
        t += h;
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(gives_taguchis_numbers) {
    const auto collision = normal_collision(bed, Attraction::kept);
    // The parameters are rounded to 17 digits.
    BOOST_TEST(collision.restitution == 0.8, tt::tolerance(1e-14));
    BOOST_TEST(collision.contact_time == 0.1, tt::tolerance(1e-14));
    BOOST_TEST(collision.force_time == collision.contact_time);
}

BOOST_AUTO_TEST_CASE(gives_the_known_cut_restitution) {
    // Eight digits are known.
    BOOST_TEST(normal_collision(bed, Attraction::cut).restitution == 0.80809934,
               tt::tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(inverse_gives_taguchis_parameters) {
    const auto contact = contact_from(0.8, 0.1, reduced_mass(1, 1));
    BOOST_TEST(contact.stiffness == bed.stiffness, tt::tolerance(1e-15));
    BOOST_TEST(contact.damping == bed.damping, tt::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(inverse_is_the_inverse_also_against_a_frozen_grain) {
    const double frozen = std::numeric_limits<double>::infinity();
    for (const double e : {0.01, 0.3, 0.8, 0.99, 1.0}) {
        for (const double m2 : {0.2, 1.0, 7.0, frozen}) {
            const auto contact = contact_from(e, 0.37, reduced_mass(2.5, m2));
            const auto collision = normal_collision(contact, Attraction::kept);
            // A few roundings; 1 - e is not resolved better than that.
            BOOST_TEST(collision.restitution == e, tt::tolerance(1e-13));
            BOOST_TEST(collision.contact_time == 0.37, tt::tolerance(1e-13));
        }
    }
}

BOOST_AUTO_TEST_CASE(reduced_mass_of_two_and_of_one_body) {
    BOOST_TEST(reduced_mass(1, 1) == 0.5);
    BOOST_TEST(reduced_mass(3, std::numeric_limits<double>::infinity()) == 3);
    BOOST_CHECK_THROW(static_cast<void>(reduced_mass(0, 1)), std::domain_error);
    const double infinite = std::numeric_limits<double>::infinity();
    BOOST_CHECK_THROW(static_cast<void>(reduced_mass(infinite, infinite)), std::domain_error);
    BOOST_CHECK_THROW(static_cast<void>(reduced_mass(std::nan(""), 1)), std::domain_error);
}

BOOST_AUTO_TEST_CASE(agrees_with_numerical_integration_in_all_regimes) {
    // Linear interpolation of events in steps of 1e-5 leaves about 1e-10 of the time scale.
    const auto tolerance = tt::tolerance(1e-8);
    for (const double damping : {0.0, 0.3, 1.0, 1.9}) {
        const NormalContact contact{1.7, damping, 0.6};
        const auto exact = normal_collision(contact, Attraction::kept);
        const auto integrated = integrate(contact, false);
        BOOST_TEST(exact.restitution == integrated.restitution, tolerance);
        BOOST_TEST(exact.contact_time == integrated.contact_time, tolerance);
    }
    const double critical = 2 * std::sqrt(1.7 * 0.6);
    for (const double damping : {0.3, 1.9, critical, 2.5, 6.0}) {
        const NormalContact contact{1.7, damping, 0.6};
        const auto exact = normal_collision(contact, Attraction::cut);
        const auto integrated = integrate(contact, true);
        BOOST_TEST(exact.restitution == integrated.restitution, tolerance);
        BOOST_TEST(exact.force_time == integrated.force_time, tolerance);
        BOOST_TEST(exact.contact_time == integrated.contact_time, tolerance);
    }
}

BOOST_AUTO_TEST_CASE(cut_collision_is_continuous_through_critical_damping) {
    const double critical = 2.0;  // k = mu = 1
    const auto at = [](double damping) {
        return normal_collision({1.0, damping, 1.0}, Attraction::cut);
    };
    BOOST_TEST(at(critical).restitution == std::exp(-2.0), tt::tolerance(1e-15));
    BOOST_TEST(at(critical).force_time == 2.0, tt::tolerance(1e-15));
    // Either side of every switch between the branches; d(ln e)/d(eta) is about -1.
    for (const double offset : {1e-3, 1e-4, 5e-5, 1e-5, 1e-7, 1e-10}) {
        for (const double sign : {-1.0, 1.0}) {
            const double below = at(critical + sign * offset * (1 - 1e-9)).restitution;
            const double above = at(critical + sign * offset * (1 + 1e-9)).restitution;
            BOOST_TEST(below == above, tt::tolerance(1e-11));
        }
    }
}

BOOST_AUTO_TEST_CASE(undamped_collision_is_elastic_either_way) {
    for (const auto attraction : {Attraction::kept, Attraction::cut}) {
        const auto collision = normal_collision({4.0, 0.0, 0.25}, attraction);
        BOOST_TEST(collision.restitution == 1.0);
        BOOST_TEST(collision.contact_time == std::numbers::pi / 4, tt::tolerance(1e-15));
    }
}

BOOST_AUTO_TEST_CASE(cutting_attraction_raises_restitution_and_lengthens_nothing_but_the_overlap) {
    const auto kept = normal_collision(bed, Attraction::kept);
    const auto cut = normal_collision(bed, Attraction::cut);
    BOOST_TEST(cut.restitution > kept.restitution);
    BOOST_TEST(cut.force_time < kept.force_time);
    BOOST_TEST(cut.contact_time > cut.force_time);
}

BOOST_AUTO_TEST_CASE(rejects_what_has_no_answer) {
    const auto reject = [](NormalContact contact, Attraction attraction) {
        BOOST_CHECK_THROW(static_cast<void>(normal_collision(contact, attraction)),
                          std::domain_error);
    };
    reject({1.0, 2.0, 1.0}, Attraction::kept);  // critically damped: never parts
    reject({1.0, 3.0, 1.0}, Attraction::kept);
    reject({0.0, 0.1, 1.0}, Attraction::cut);
    reject({1.0, -0.1, 1.0}, Attraction::cut);
    reject({1.0, 0.1, 0.0}, Attraction::kept);
    reject({std::nan(""), 0.1, 1.0}, Attraction::kept);
    for (const double e : {0.0, -0.5, 1.0000001, std::nan("")}) {
        BOOST_CHECK_THROW(static_cast<void>(contact_from(e, 0.1, 0.5)), std::domain_error);
    }
    BOOST_CHECK_THROW(static_cast<void>(contact_from(0.8, 0.0, 0.5)), std::domain_error);
}
