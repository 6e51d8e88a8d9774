// Friction in YADE, held against the reference integrator with YADE's conventions; and defects of
// its input that must be seen.
#include "adapters/yade/yade_code.hpp"
#include "tests/support/external_code.hpp"
#include "tests/support/frictional_suite.hpp"

#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <string>
#include <utility>
#include <vector>

using namespace crossgrain;
using namespace crossgrain::tests;
using adapters::YadeCode;
using scene::Clipping;
using NeedsYade = NeedsCode<YadeCode>;
BOOST_TEST_GLOBAL_FIXTURE(NeedsYade);

namespace {

// Round-off of some thousand kicks at speeds and spins up to 20.
constexpr double pair_limit = 1e-11;
// Ten contact times, in which collisions multiply differences.
constexpr double gas_limit = 1e-9;
// What a defect does to the same scenes.
constexpr double seen = 1e-4;

const auto yade = scene::conventions_named("yade").value();

double difference(const scene::Scene& scene) {
    return friction_difference(YadeCode(), scene, yade);
}

const std::vector<NamedLaw>& laws() {
    static const std::vector<NamedLaw> all{
        {"spring, clipped", frictional_law()},
        {"spring and dashpot, clipped, another inertia", with_inertia(0.3, frictional_law(5))},
        {"spring and dashpot, attraction kept", frictional_law(damping, Clipping::none)},
        {"dashpot, clipped", dashpot_law()},
        {"elastic spring, clipping none", elastic(frictional_law(0, Clipping::none))},
        {"per effective mass, clipped", per_effective_mass(frictional_law(5))},
        {"per effective mass, attraction kept",
         per_effective_mass(frictional_law(damping, Clipping::none))},
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

BOOST_AUTO_TEST_CASE(a_spring_starts_anew_with_each_contact) {
    // While the attraction is kept, a spring is loaded to the end of its contact.
    BOOST_TEST(difference(grain_in_a_valley(frictional_law(damping, Clipping::none))) < pair_limit);
}

BOOST_AUTO_TEST_CASE(pipe_with_drag_and_backing_planes) {
    BOOST_TEST(difference(pipe_in_small(frictional_law())) < gas_limit);
}

BOOST_AUTO_TEST_CASE(pipe_without_friction) {
    BOOST_TEST(frictionless_difference(YadeCode(), yade, Coordinates::unwrapped) < gas_limit);
}

BOOST_AUTO_TEST_CASE(a_plate_reaches_to_the_surface_of_each_grain) {
    using scene::PlateContact;
    auto surface = empty_scene("plate-and-grains-that-differ", 1e-4, 1.0);
    surface.contact = frictional_law();
    add_disc(surface, {0, 0.6}, {0, -1}, 0, 1.6);
    add_disc(surface, {5, 3.0}, {0, 0}, 0, 2.0);
    surface.plates = {.stiffness = stiffness,
                      .touches = PlateContact::surface,
                      .bottom = scene::PrescribedPlate{.height = -0.3},
                      .lid = {}};
    auto centre = surface;
    centre.plates.touches = PlateContact::centre;
    centre.plates.bottom->height += 0.8;
    const auto found = frames_of(YadeCode(), surface);
    BOOST_TEST(largest_difference(found, frames_of(YadeCode(), centre)) < pair_limit);
    BOOST_TEST(found.back().vy[0] > 0.9);
}

BOOST_AUTO_TEST_CASE(gas_of_64_discs_after_ten_contact_times) {
    for (const auto& law :
         {frictional_law(), frictional_law(damping, Clipping::none), dashpot_law()})
        BOOST_TEST(difference(frictional_gas(law)) < gas_limit);
}

BOOST_AUTO_TEST_CASE(defects_are_seen) {
    const auto scene = frictional_pairs(frictional_law());
    const auto reference = reference_frames(scene, yade);
    const std::vector<std::pair<std::string, Edit>> defects{
        {"tangential stiffness doubled",
         {"laws.py", "2 * friction['stiffness'], 2", "4 * friction['stiffness'], 2"}},
        {"friction 5 % off",
         {"laws.py", "material.frictionAngle = math.atan(friction['coefficient'])\n        if",
          "material.frictionAngle = math.atan(1.05 * friction['coefficient'])\n        if"}},
        {"inertia of a disc", {"scene.py", "scene.friction['inertia_factor']", "0.5"}},
    };
    for (const auto& [name, edit] : defects) {
        const double found =
            largest_difference(frames_of_edited(YadeCode(), scene, edit), reference);
        BOOST_TEST_MESSAGE(name << ": " << found);
        BOOST_TEST(found > seen, name);
    }
}
