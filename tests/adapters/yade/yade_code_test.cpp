// YADE itself, held against the reference integrator: every law and every kind of plate must agree
// to round-off, and a run that makes no sense must end with an error that says so.
#include "adapters/yade/yade_code.hpp"
#include "native/base/errors.hpp"
#include "tests/support/adapter_run.hpp"
#include "tests/support/external_code.hpp"
#include "tests/support/scenes.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

using namespace crossgrain;
using namespace crossgrain::tests;
using adapters::YadeCode;
using scene::Clipping;
using scene::Damping;
using scene::Spins;
using NeedsYade = NeedsCode<YadeCode>;
BOOST_TEST_GLOBAL_FIXTURE(NeedsYade);

namespace {

// Two grains at speeds of order 1: some 1e4 steps, each adding at most an ulp of order 1e-16.
constexpr double pair_tolerance = 1e-13;
// With gravity YADE's velocity is kicked once where the reference is kicked twice: round-off of
// 1e4 to 3e4 kicks, times the stiffness of the contacts that follow.
constexpr double plate_tolerance = 1e-10;
// Each collision multiplies differences; some ten collision times.
constexpr double gas_tolerance = 1e-10;

double difference(const scene::Scene& scene) {
    const double found = largest_difference(frames_of(YadeCode(), scene), reference_frames(scene));
    BOOST_TEST_MESSAGE(scene.name << ": " << found);
    return found;
}

scene::Scene with(scene::Scene scene, Damping damping, Clipping clipping, Spins spins) {
    scene.contact.damping_acts_on = damping;
    scene.contact.clipping = clipping;
    scene.contact.spins = spins;
    return scene;
}

/// 64 discs in a box that is periodic along x and y.
scene::Scene periodic_gas() {
    auto gas = empty_scene("periodic-gas", 1e-4, 1.0);
    gas.periodic_x = gas.periodic_y = 20.0;
    std::mt19937_64 random(3);
    std::normal_distribution<double> speed(0.0, 3.0);
    for (int row = 0; row < 8; ++row) {
        for (int column = 0; column < 8; ++column) {
            add_grain(gas, 2.5 * column, 2.5 * row, speed(random), speed(random));
        }
    }
    return gas;
}

std::string failure_of(const scene::Scene& scene, double time_limit) {
    try {
        frames_of(YadeCode(), scene, time_limit);
    } catch (const AdapterError& error) {
        return error.details().reason;
    }
    return {};
}

}  // namespace

BOOST_AUTO_TEST_CASE(names_its_version) {
    BOOST_TEST(!YadeCode().probe().version.empty());
    BOOST_TEST(YadeCode().probe().version.find_first_of(" \n") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(head_on_collision) {
    BOOST_TEST(difference(head_on_pair()) < pair_tolerance);
}

BOOST_AUTO_TEST_CASE(every_variant_of_the_law) {
    for (const auto damping : {Damping::full_vector, Damping::normal_only}) {
        for (const auto clipping : {Clipping::none, Clipping::all, Clipping::normal_only}) {
            for (const auto spins : {Spins::off, Spins::on}) {
                const auto scene = with(oblique_pair(), damping, clipping, spins);
                BOOST_TEST_CONTEXT(to_string(damping)
                                   << ", " << to_string(clipping) << ", " << to_string(spins)) {
                    BOOST_TEST(difference(scene) < pair_tolerance);
                }
            }
        }
    }
}

/// Were two variants the same in this scene, the test above could not tell them apart.
BOOST_AUTO_TEST_CASE(the_variants_differ) {
    std::vector<std::vector<KeptFrame>> outcomes;
    const auto add = [&](Damping damping, Clipping clipping, Spins spins) {
        outcomes.push_back(reference_frames(with(oblique_pair(), damping, clipping, spins)));
    };
    for (const auto clipping : {Clipping::none, Clipping::all, Clipping::normal_only}) {
        for (const auto spins : {Spins::off, Spins::on})
            add(Damping::full_vector, clipping, spins);
    }
    // Without tangential force: spins stay at rest and there is nothing but the normal force to
    // cut.
    add(Damping::normal_only, Clipping::none, Spins::off);
    add(Damping::normal_only, Clipping::all, Spins::off);
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            BOOST_TEST_CONTEXT(i << " and " << j) {
                BOOST_TEST(largest_difference(outcomes[i], outcomes[j]) > 1e-4);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(spins_left_on_are_seen) {
    const auto wrong = with(oblique_pair(), Damping::full_vector, Clipping::none, Spins::on);
    const auto found = frames_of(YadeCode(), wrong);
    BOOST_TEST(largest_difference(found, reference_frames(oblique_pair())) > 1e-3);
}

BOOST_AUTO_TEST_CASE(plates) {
    using scene::PlateContact;
    for (const auto& scene :
         {bounce_on_bottom(PlateContact::centre), bounce_on_bottom(PlateContact::surface),
          moving_bottom(), prescribed_lid(), free_lid_collision(), small_bed()}) {
        BOOST_TEST_CONTEXT(scene.name) {
            BOOST_TEST(difference(scene) < plate_tolerance);
        }
    }
}

BOOST_AUTO_TEST_CASE(vibrated_bed_with_every_part_of_the_law) {
    const auto bed = with(small_bed(), Damping::full_vector, Clipping::all, Spins::on);
    BOOST_TEST(difference(bed) < plate_tolerance);
}

BOOST_AUTO_TEST_CASE(frozen_partner) {
    BOOST_TEST(difference(frozen_target()) < pair_tolerance);
    auto head_on = head_on_pair();
    head_on.initial.frozen = {false, true};
    head_on.initial.vx = {1.0, 0.0};
    BOOST_TEST(difference(head_on) < pair_tolerance);
    // A partner that never moves: reduced mass m, hence omega^2 = k - eta^2/4.
    const double omega = std::sqrt(stiffness - damping * damping / 4);
    const double restitution = std::exp(-damping * std::numbers::pi / (2 * omega));
    const auto frames = frames_of(YadeCode(), head_on);
    BOOST_TEST(frames.back().vx[1] == 0.0);
    // The contact ends up to one step late: relative error about 10 dt.
    BOOST_TEST(std::abs(-frames.back().vx[0] - restitution) < 1e-3);
}

BOOST_AUTO_TEST_CASE(two_frozen_grains_that_overlap_ignore_each_other) {
    auto scene = frozen_target();
    add_grain(scene, scene.initial.x[1] + 1.0, scene.initial.y[1], 0.0, 0.0);
    scene.initial.frozen.push_back(true);
    BOOST_TEST(difference(scene) < pair_tolerance);
}

BOOST_AUTO_TEST_CASE(gas_of_64_discs) {
    for (const auto damping : {Damping::full_vector, Damping::normal_only}) {
        for (const auto clipping : {Clipping::none, Clipping::all, Clipping::normal_only}) {
            const auto gas = with(periodic_gas(), damping, clipping, Spins::off);
            BOOST_TEST_CONTEXT(to_string(damping) << ", " << to_string(clipping)) {
                BOOST_TEST(difference(gas) < gas_tolerance);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(gas_that_is_open_along_y_and_spins) {
    const auto gas = with(small_gas(), Damping::full_vector, Clipping::normal_only, Spins::on);
    BOOST_TEST(difference(gas) < gas_tolerance);
}

BOOST_AUTO_TEST_CASE(a_period_just_above_two_diameters) {
    auto pair = with(oblique_pair(), Damping::full_vector, Clipping::none, Spins::off);
    pair.periodic_x = 4.01;
    BOOST_TEST(difference(pair) < pair_tolerance);
}

BOOST_AUTO_TEST_CASE(start_with_contacts) {
    auto pair = with(oblique_pair(), Damping::full_vector, Clipping::none, Spins::on);
    pair.initial.x = {-0.8, 0.8};
    BOOST_TEST_REQUIRE(scene::initial_contacts(pair) == 1);
    BOOST_TEST(difference(pair) < pair_tolerance);
    auto bed = small_bed();
    for (double& y : bed.initial.y)
        y -= 0.2;
    std::get<scene::FreeLid>(bed.plates.lid).height = 3.7;
    BOOST_TEST_REQUIRE(scene::initial_contacts(bed) > 0);
    BOOST_TEST(difference(bed) < plate_tolerance);
}

BOOST_AUTO_TEST_CASE(absurd_time_steps_end_with_a_reason) {
    for (const double dt : {0.2, 10.0, 1e6}) {
        auto gas = periodic_gas();
        gas.dt = dt;
        BOOST_TEST_CONTEXT("dt = " << dt) {
            const std::string reason = failure_of(gas, 30);
            BOOST_TEST(reason.find("contacts are jumped over") != std::string::npos, reason);
        }
    }
}

BOOST_AUTO_TEST_CASE(an_error_in_python_ends_the_run_with_its_text) {
    auto pair = head_on_pair();
    pair.contact.stiffness = std::nan("");  // no scene reader lets this pass; null in JSON
    const std::string reason = failure_of(pair, 30);
    BOOST_TEST(reason.find("TypeError") != std::string::npos, reason);
}
