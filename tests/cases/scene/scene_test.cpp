// The scene's own arithmetic: contact time, plate motion, nearest images, contacts at the start.
#include "cases/scene/scene.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>

namespace tt = boost::test_tools;
using namespace crossgrain::scene;

namespace {

Scene with_contact(double mass, double stiffness, double damping) {
    Scene scene{.name = {}, .grains = {.diameter = 2, .mass = mass}};
    scene.contact.stiffness = stiffness;
    scene.contact.damping = damping;
    return scene;
}

}  // namespace

BOOST_AUTO_TEST_CASE(contact_time_is_half_a_period_of_the_damped_pair) {
    BOOST_TEST(contact_time(with_contact(1, 0.5, 0)) == std::numbers::pi, tt::tolerance(1e-15));
    BOOST_TEST(contact_time(with_contact(2, 1, 0)) == std::numbers::pi, tt::tolerance(1e-15));
    BOOST_TEST(contact_time(with_contact(1, 495.96987227912376, 2.2314355131420975)) == 0.1,
               tt::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(an_overdamped_contact_never_ends) {
    BOOST_TEST(std::isinf(contact_time(with_contact(1, 0.5, 1))));  // critical
    BOOST_TEST(std::isinf(contact_time(with_contact(1, 0.5, 1.5))));
    BOOST_TEST(std::isfinite(contact_time(with_contact(1, 0.5, 0.999))));
}

BOOST_AUTO_TEST_CASE(a_prescribed_plate_starts_at_its_highest) {
    const PrescribedPlate plate{.height = 1, .amplitude = 2, .period = 6};
    BOOST_TEST(height_at(plate, 0) == 3.0);
    // 1e-15: pi is rounded.
    BOOST_TEST(height_at(plate, 3) == -1.0, tt::tolerance(1e-15));
    BOOST_TEST(std::abs(height_at(plate, 2)) < 1e-14);
    BOOST_TEST(std::abs(height_at(plate, 1.5) - 1) < 1e-14);
    BOOST_TEST(height_at(plate, 6) == 3.0, tt::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(the_nearest_image_is_within_half_a_period) {
    BOOST_TEST(nearest_image(7, {}) == 7.0);
    BOOST_TEST(nearest_image(7, 10.0) == -3.0);
    BOOST_TEST(nearest_image(-7, 10.0) == 3.0);
    BOOST_TEST(nearest_image(3, 10.0) == 3.0);
    BOOST_TEST(nearest_image(1003, 10.0) == 3.0);
    BOOST_TEST(std::abs(nearest_image(5, 10.0)) == 5.0);
}

BOOST_AUTO_TEST_CASE(contacts_at_the_start_count_pairs_images_and_plates) {
    auto scene = with_contact(1, 500, 0);
    scene.initial.x = {0, 1.5, 9, 5};
    scene.initial.y = {5, 5, 5, 9.5};
    BOOST_TEST(initial_contacts(scene) == 1u);
    scene.periodic_x = 10;
    BOOST_TEST(initial_contacts(scene) == 2u);  // grain 2 meets grain 0 across the period
    scene.plates.lid = FreeLid{.mass = 1, .height = 9};
    BOOST_TEST(initial_contacts(scene) == 3u);
    scene.plates.lid = PrescribedPlate{.height = 9, .amplitude = 1, .period = 1};
    BOOST_TEST(initial_contacts(scene) == 2u);  // at 10 when the run starts
    scene.plates.touches = PlateContact::surface;
    BOOST_TEST(initial_contacts(scene) == 3u);
    scene.plates.bottom = PrescribedPlate{.height = 4};
    BOOST_TEST(initial_contacts(scene) == 3u);  // exactly on the surfaces of three grains
    scene.plates.bottom->height = 4.1;
    BOOST_TEST(initial_contacts(scene) == 6u);
}
