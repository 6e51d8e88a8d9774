// Scenes with friction, and with grains that differ, run on the frictional engine: its frames are
// those of the reference integrator for every convention, and what it lacks is refused.
#include "adapters/native/native_dem_code.hpp"
#include "tests/support/frictional_suite.hpp"

#include <boost/test/unit_test.hpp>

#include <string>
#include <vector>

using namespace crossgrain;
using adapters::NativeDemCode;
using tests::refuses;

namespace {

const NativeDemCode code("test");

std::vector<scene::FrictionConventions> all_conventions() {
    using namespace scene;
    std::vector<FrictionConventions> all;
    for (const auto velocity : {Lever::radius, Lever::contact_point}) {
        for (const auto torque : {Lever::radius, Lever::contact_point}) {
            for (const auto rotation :
                 {SpringRotation::project, SpringRotation::project_and_rescale,
                  SpringRotation::rotate}) {
                for (const auto limit : {CoulombLimit::total, CoulombLimit::spring_only})
                    all.push_back({velocity, torque, rotation, limit});
            }
        }
    }
    return all;
}

double difference(scene::Scene s, const scene::FrictionConventions& conventions) {
    s.contact.friction->conventions = conventions;
    return tests::friction_difference(code, s, conventions, tests::Coordinates::wrapped);
}

// A wrong term shows at 1e-6 or more.
constexpr double pair_limit = 1e-12, gas_limit = 1e-10;

}  // namespace

BOOST_AUTO_TEST_CASE(pairs_collide_as_in_the_reference_for_every_convention) {
    for (const auto& conventions : all_conventions()) {
        for (const double damping : {0.0, 2.0}) {
            const auto pairs = tests::frictional_pairs(tests::frictional_law(damping), 1e-3);
            BOOST_TEST(difference(pairs, conventions) < pair_limit);
        }
    }
}

BOOST_AUTO_TEST_CASE(so_they_do_with_every_clipping_and_without_history) {
    const scene::FrictionConventions conventions;
    for (const auto clipping :
         {scene::Clipping::none, scene::Clipping::all, scene::Clipping::normal_only}) {
        BOOST_TEST(difference(tests::frictional_pairs(tests::frictional_law(1, clipping), 1e-3),
                              conventions) < pair_limit);
        BOOST_TEST(difference(tests::frictional_pairs(tests::dashpot_law(clipping), 1e-3),
                              conventions) < pair_limit);
    }
    auto law = tests::frictional_law(2);
    law.damping_scale = scene::DampingScale::effective_mass;
    BOOST_TEST(difference(tests::frictional_pairs(law, 1e-3), conventions) < pair_limit);
}

BOOST_AUTO_TEST_CASE(gases_pipes_and_valleys_are_those_of_the_reference) {
    for (const auto* name : {"lammps-granular", "lammps-hooke-history", "liggghts", "yade"}) {
        const auto conventions = scene::conventions_named(name).value();
        const auto law = tests::frictional_law(1);
        BOOST_TEST(difference(tests::frictional_gas(law), conventions) < gas_limit);
        BOOST_TEST(difference(tests::pipe_in_small(law), conventions) < gas_limit);
        BOOST_TEST(difference(tests::grain_in_a_valley(law, 1e-3), conventions) < gas_limit);
    }
    BOOST_TEST(tests::frictionless_difference(code, {}, tests::Coordinates::wrapped) < gas_limit);
}

BOOST_AUTO_TEST_CASE(own_conventions_are_those_of_liggghts) {
    const auto s = tests::frictional_pairs(tests::frictional_law(1), 1e-3);
    BOOST_TEST(!s.contact.friction->conventions.has_value());
    BOOST_TEST(tests::friction_difference(code, s, scene::conventions_named("liggghts").value()) <
               pair_limit);
}

BOOST_AUTO_TEST_CASE(another_convention_or_moment_of_inertia_is_noticed) {
    // The judge of the tests above.
    auto s = tests::frictional_pairs(tests::frictional_law(1), 1e-3);
    for (const auto* name : {"lammps-granular", "lammps-hooke-history", "yade"}) {
        BOOST_TEST(tests::friction_difference(code, s, scene::conventions_named(name).value()) >
                   1e-7);
    }
    const auto right = tests::reference_frames(s, scene::FrictionConventions{});
    s.contact.friction->inertia_factor = tests::disc;
    BOOST_TEST(tests::largest_difference(tests::frames_of(code, s), right) > 1e-2);
}

BOOST_AUTO_TEST_CASE(frames_have_spins_with_friction_and_not_otherwise) {
    auto s = tests::frictional_gas(tests::frictional_law());
    const auto frames = tests::frames_of(code, s);
    BOOST_TEST((frames.front().omega == s.initial.omega && frames.front().x == s.initial.x));
    s.contact.friction.reset();
    BOOST_TEST(tests::frames_of(code, s).back().omega.empty());
}

BOOST_AUTO_TEST_CASE(what_it_lacks_is_refused) {
    const auto gas = tests::frictional_gas(tests::frictional_law());
    BOOST_TEST(!code.cannot_express(gas).has_value());
    const auto with = [&](auto change) {
        auto s = gas;
        change(s);
        return s;
    };
    using scene::Scene;
    BOOST_TEST(refuses(
        code, with([](Scene& s) { s.contact.damping_acts_on = scene::Damping::full_vector; }),
        "full-vector"));
    BOOST_TEST(refuses(code, with([](Scene& s) { s.contact.spins = scene::Spins::off; }),
                       "spins = \"on\""));
    BOOST_TEST(refuses(code,
                       with([](Scene& s) { s.integrator = scene::Integrator::verlet_predicted; }),
                       "verlet-half-step"));
    BOOST_TEST(refuses(code,
                       with([](Scene& s) { s.contacts = scene::Contacts::lattice_neighbours; }),
                       "neighbour-list"));
    BOOST_TEST(refuses(code, with([](Scene& s) { s.precision = scene::Precision::mixed; }),
                       "precision = \"double\""));
    BOOST_TEST(refuses(code, with([](Scene& s) { s.plates.bottom = scene::PrescribedPlate{}; }),
                       "plates"));
    BOOST_TEST(
        refuses(code, with([](Scene& s) { s.plates.lid = scene::FreeLid{.mass = 1}; }), "plates"));
    BOOST_TEST(refuses(code, with([](Scene& s) { s.periodic_x = 6.0; }), "3 diameters"));
    BOOST_TEST(refuses(code, with([](Scene& s) {
                           s.backing = scene::BackingPlanes{1, 0, 20};
                       }),
                       "backing planes"));
}
