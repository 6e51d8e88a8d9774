// Friction in LIGGGHTS, held against the reference integrator with its conventions; and defects of
// its input that must be seen.
#include "adapters/liggghts/liggghts_code.hpp"
#include "tests/support/external_code.hpp"
#include "tests/support/frictional_suite.hpp"

#include <boost/test/unit_test.hpp>

#include <string>
#include <utility>
#include <vector>

using namespace crossgrain;
using namespace crossgrain::tests;
using adapters::LiggghtsCode;
using scene::Clipping;
using NeedsLiggghts = NeedsCode<LiggghtsCode>;
BOOST_TEST_GLOBAL_FIXTURE(NeedsLiggghts);

namespace {

// Round-off of some thousand kicks at speeds and spins up to 20.
constexpr double pair_limit = 1e-12;
// Ten contact times, in which collisions multiply differences.
constexpr double gas_limit = 1e-11;
// What a defect does to the same scenes.
constexpr double seen = 1e-4;

const auto liggghts = scene::conventions_named("liggghts").value();

double difference(const scene::Scene& scene) {
    return friction_difference(LiggghtsCode(), scene, liggghts, Coordinates::wrapped);
}

const std::vector<NamedLaw>& laws() {
    static const std::vector<NamedLaw> all{
        {"spring, clipped", frictional_law()},
        {"spring, attraction kept", frictional_law(0, Clipping::none)},
        {"spring and dashpot, clipped, disc", with_inertia(disc, frictional_law(5))},
        {"spring and dashpot, attraction kept", frictional_law(5, Clipping::none)},
        {"dashpot, clipped", dashpot_law()},
        {"dashpot, attraction kept", dashpot_law(Clipping::none)},
        {"elastic spring", elastic(frictional_law())},
        {"per effective mass", per_effective_mass(frictional_law(5))},
        {"dashpot per effective mass, disc", per_effective_mass(with_inertia(disc, dashpot_law()))},
    };
    return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(pairs_in_every_law) {
    for (const auto& [name, law] : laws()) {
        BOOST_TEST_CONTEXT(name) {
            BOOST_TEST(difference(frictional_pairs(law)) < pair_limit);
        }
    }
}

/// Springs start to grow after t = 0, dashpots act at once.
BOOST_AUTO_TEST_CASE(start_with_contacts) {
    for (const auto& law : {frictional_law(5), dashpot_law()}) {
        auto pair = empty_scene("contact-at-start", 1e-4, 0.2);
        pair.contact = law;
        add_disc(pair, {0, 0}, {0.5, 1}, 2, 2.0);
        add_disc(pair, {1.8, 0.3}, {-0.5, 0}, -1, 2.0);
        BOOST_TEST(difference(pair) < pair_limit);
    }
}

BOOST_AUTO_TEST_CASE(pipe_with_drag_and_backing_planes) {
    BOOST_TEST(difference(pipe_in_small(frictional_law())) < gas_limit);
    BOOST_TEST(difference(pipe_in_small(with_inertia(disc, frictional_law()))) < gas_limit);
}

BOOST_AUTO_TEST_CASE(pipe_without_friction) {
    BOOST_TEST(frictionless_difference(LiggghtsCode(), liggghts, Coordinates::wrapped) < gas_limit);
}

BOOST_AUTO_TEST_CASE(gas_of_64_discs_after_ten_contact_times) {
    for (const auto& law : {frictional_law(), frictional_law(5, Clipping::none), dashpot_law()})
        BOOST_TEST(difference(frictional_gas(law)) < gas_limit);
}

/// Without the factor, the spring of a pair that has parted is there when it meets again.
BOOST_AUTO_TEST_CASE(a_spring_starts_anew_with_each_contact) {
    // While the attraction is kept, a spring is loaded to the end of its contact.
    const auto scene = grain_in_a_valley(frictional_law(0, Clipping::none));
    BOOST_TEST(difference(scene) < pair_limit);
    const Edit edit{"in.liggghts", "neigh_modify contact_distance_factor 1.05\n", ""};
    const double found = largest_difference(frames_of_edited(LiggghtsCode(), scene, edit),
                                            reference_frames(scene, liggghts));
    BOOST_TEST_MESSAGE("stale spring: " << found);
    BOOST_TEST(found > seen);
}

BOOST_AUTO_TEST_CASE(defects_are_seen) {
    auto scene = frictional_pairs(per_effective_mass(frictional_law()));
    scene.contact.friction->stiffness = 128;
    const auto reference = reference_frames(scene, liggghts);
    const std::string kt = "fix kt all property/global kt peratomtypepair 2 ";
    const std::string mu = "fix coefficientFriction all property/global coefficientFriction "
                           "peratomtypepair 2 ";
    const std::vector<std::pair<std::string, Edit>> defects{
        {"tangential stiffness doubled",
         {"in.liggghts", kt + "128 128 128 128", kt + "256 256 256 256"}},
        {"friction 5 % off",
         {"in.liggghts", mu + "0.5 0.5 0.5 0.5", mu + "0.525 0.525 0.525 0.525"}},
        {"inertia of a disc",
         {"in.liggghts", "dimension 3\nboundary s s f", "dimension 2\nboundary s s p"}},
        {"frozen grains of finite mass in the damping",
         {"in.liggghts", "fix hold frozen freeze\n", ""}},
    };
    for (const auto& [name, edit] : defects) {
        const double found =
            largest_difference(frames_of_edited(LiggghtsCode(), scene, edit), reference);
        BOOST_TEST_MESSAGE(name << ": " << found);
        BOOST_TEST(found > seen, name);
    }
}
