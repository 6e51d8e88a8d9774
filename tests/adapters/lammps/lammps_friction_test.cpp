// Friction in LAMMPS, held against the reference integrator in the conventions of its two families
// of pair styles; and defects of its input that must be seen.
#include "adapters/lammps/lammps_code.hpp"
#include "tests/support/external_code.hpp"
#include "tests/support/frictional_suite.hpp"

#include <boost/test/unit_test.hpp>
#include <fmt/format.h>

#include <string>
#include <vector>

using namespace crossgrain;
using namespace crossgrain::tests;
using adapters::LammpsCode;
using scene::Clipping;
using NeedsLammps = NeedsCode<LammpsCode>;
BOOST_TEST_GLOBAL_FIXTURE(NeedsLammps);

namespace {

// Round-off of some thousand kicks at speeds and spins up to 20.
constexpr double pair_limit = 1e-12;
// Ten contact times, in which collisions multiply differences.
constexpr double gas_limit = 1e-11;
// What a defect does to the same scenes.
constexpr double seen = 1e-4;

const auto granular = scene::conventions_named("lammps-granular").value();
const auto hooke = scene::conventions_named("lammps-hooke-history").value();

scene::ContactLaw with(scene::ContactLaw law, const scene::FrictionConventions& conventions) {
    law.friction->conventions = conventions;
    return law;
}

/// Damping per unit of the effective mass of two grains of mass 1.
scene::ContactLaw per_mass(scene::ContactLaw law) {
    law.damping_scale = scene::DampingScale::effective_mass;
    law.damping *= 2;
    law.friction->damping *= 2;
    return law;
}

std::vector<scene::ContactLaw> laws() {
    return {frictional_law(),    frictional_law(0, Clipping::none),
            frictional_law(1.1), frictional_law(1.1, Clipping::none),
            dashpot_law(),       dashpot_law(Clipping::none)};
}

scene::Scene alike(scene::Scene scene) {
    scene.grains.diameters.clear();
    scene.grains.masses.clear();
    return scene;
}

/// The same collisions, but every grain is of one size.
scene::Scene pairs_alike(const scene::ContactLaw& law) {
    auto scene = empty_scene("pairs-alike", 1e-4, 0.2);
    scene.contact = law;
    double row = 0;
    for (const auto partner : {Partner::alike, Partner::frozen}) {
        for (int column = 0; column < 8; ++column) {
            add_colliding_pair(scene, {8.0 * column, 8 * row}, partner, 0.7 * column + row,
                               1.5 * column - 4, {3.0 * column - 10, 2.0});
        }
        ++row;
    }
    return alike(scene);
}

double difference(const scene::Scene& scene, const scene::FrictionConventions& conventions) {
    return friction_difference(LammpsCode(), scene, conventions);
}

/// Of positions alone: in a collision velocities differ by the contact's frequency, some 40, times
/// as much, and spins more.
double distance(const scene::Scene& scene, const scene::FrictionConventions& conventions) {
    const auto positions = [](std::vector<KeptFrame> frames) {
        for (auto& frame : frames) {
            frame.vx.clear();
            frame.vy.clear();
            frame.omega.clear();
        }
        return frames;
    };
    const double found = largest_difference(positions(frames_of(LammpsCode(), scene)),
                                            positions(reference_frames(scene, conventions)));
    BOOST_TEST_MESSAGE(scene.name << ", positions: " << found);
    return found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(pairs_follow_granular) {
    for (const auto& law : laws()) {
        BOOST_TEST(difference(frictional_pairs(with(law, granular)), granular) < pair_limit);
        BOOST_TEST(difference(frictional_pairs(with(per_mass(law), granular)), granular) <
                   pair_limit);
    }
}

BOOST_AUTO_TEST_CASE(pairs_follow_gran_hooke_per_effective_mass) {
    for (const auto& law : laws())
        BOOST_TEST(difference(frictional_pairs(with(per_mass(law), hooke)), hooke) < pair_limit);
}

BOOST_AUTO_TEST_CASE(pairs_of_one_size_follow_gran_hooke_with_absolute_damping) {
    for (const auto& law : laws())
        BOOST_TEST(difference(pairs_alike(with(law, hooke)), hooke) < pair_limit);
}

BOOST_AUTO_TEST_CASE(discs_have_another_moment_of_inertia_than_spheres) {
    auto law = with(frictional_law(), granular);
    law.friction->inertia_factor = disc;
    BOOST_TEST(difference(frictional_pairs(law), granular) < pair_limit);
    law.friction->inertia_factor = 0.45;
    BOOST_TEST(refuses(LammpsCode(), frictional_pairs(law), "0.45 m r^2"));
}

BOOST_AUTO_TEST_CASE(springs_of_a_contact_that_ended_are_forgotten) {
    for (const auto& conventions : {granular, hooke}) {
        const auto law = with(per_mass(frictional_law()), conventions);
        BOOST_TEST(difference(grain_in_a_valley(law), conventions) < gas_limit);
    }
}

BOOST_AUTO_TEST_CASE(gases_and_pipes_stay_together_for_ten_contact_times) {
    for (const auto& conventions : {granular, hooke}) {
        const auto law = with(per_mass(frictional_law()), conventions);
        BOOST_TEST(distance(frictional_gas(law), conventions) < gas_limit);
        BOOST_TEST(difference(pipe_in_small(law), conventions) < gas_limit);
    }
}

BOOST_AUTO_TEST_CASE(each_style_keeps_to_its_own_conventions) {
    const auto law = per_mass(frictional_law(1.1));
    const auto other = scene::conventions_named("liggghts").value();
    BOOST_TEST(difference(frictional_pairs(with(law, granular)), hooke) > seen);
    BOOST_TEST(difference(frictional_pairs(with(law, hooke)), granular) > seen);
    BOOST_TEST(refuses(LammpsCode(), frictional_pairs(with(law, other)),
                       "\"lammps-granular\" or \"lammps-hooke-history\""));
    // Each code its own: the one with the fewest restrictions.
    BOOST_TEST(difference(frictional_pairs(law), granular) < pair_limit);
}

BOOST_AUTO_TEST_CASE(what_a_style_lacks_is_refused_with_the_nearest_it_has) {
    auto elastic = frictional_law(1.1);
    elastic.damping = 0;
    BOOST_TEST(refuses(LammpsCode(), frictional_pairs(with(elastic, granular)),
                       "conventions lammps-hooke-history would be expressible"));
    BOOST_TEST(difference(pairs_alike(with(elastic, hooke)), hooke) < pair_limit);
    BOOST_TEST(refuses(LammpsCode(), frictional_pairs(with(frictional_law(), hooke)),
                       "damping_scale effective-mass"));
}

BOOST_AUTO_TEST_CASE(defects_of_the_input_are_seen) {
    const auto law = with(frictional_law(), granular);
    const auto scene = frictional_pairs(law);
    const auto expected = reference_frames(scene, granular);
    const auto defect = [&](const std::string& from, const std::string& to) {
        const Edit edit{.file = "in.lammps", .from = from, .to = to};
        return largest_difference(frames_of_edited(LammpsCode(), scene, edit), expected);
    };
    const std::string spring = fmt::format("linear_history {:.17g}", law.friction->stiffness);
    const std::string doubled = fmt::format("linear_history {:.17g}", 2 * law.friction->stiffness);
    BOOST_TEST(defect(spring, doubled) > seen);
    BOOST_TEST(defect("nve/sphere", "nve/sphere disc") > seen);
    BOOST_TEST(defect(" 0.5 limit_damping", " 0.525 limit_damping") > seen);
    BOOST_TEST(defect(" limit_damping", "") > seen);
    BOOST_TEST(defect("set atom 22 mass", "set atom 21 mass") > seen);
}
