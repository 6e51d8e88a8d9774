// The scene's JSON identifies a run: the same scene gives the same text, and every field that a
// code sees changes it.
#include "cases/scene/scene_json.hpp"
#include "tests/support/scenes.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <variant>
#include <vector>

using namespace crossgrain;
using scene::Scene;

namespace {

/// Every optional part is there, so that every field can be changed.
Scene full_scene() {
    auto s = tests::bed_with_obstacle();
    s.periodic_y = 100;
    return s;
}

std::string text_of(const Scene& s) {
    return scene::to_json(s).dump();
}

double next(double value) {
    return std::nextafter(value, 1e300);
}

scene::FreeLid& free_lid(Scene& s) {
    return std::get<scene::FreeLid>(s.plates.lid);
}

struct Mutation {
    std::string what;
    std::function<void(Scene&)> apply;
};

// The smallest change of each field: one unit in the last place of a number.
const std::vector<Mutation> mutations{
    {"name", [](Scene& s) { s.name += "x"; }},
    {"diameter", [](Scene& s) { s.grains.diameter = next(s.grains.diameter); }},
    {"mass", [](Scene& s) { s.grains.mass = next(s.grains.mass); }},
    {"stiffness", [](Scene& s) { s.contact.stiffness = next(s.contact.stiffness); }},
    {"damping", [](Scene& s) { s.contact.damping = next(s.contact.damping); }},
    {"damping acts on", [](Scene& s) { s.contact.damping_acts_on = scene::Damping::normal_only; }},
    {"clipping all", [](Scene& s) { s.contact.clipping = scene::Clipping::all; }},
    {"clipping normal", [](Scene& s) { s.contact.clipping = scene::Clipping::normal_only; }},
    {"spins", [](Scene& s) { s.contact.spins = scene::Spins::on; }},
    {"plate stiffness", [](Scene& s) { s.plates.stiffness = next(s.plates.stiffness); }},
    {"plates touch", [](Scene& s) { s.plates.touches = scene::PlateContact::surface; }},
    {"no bottom", [](Scene& s) { s.plates.bottom.reset(); }},
    {"bottom height", [](Scene& s) { s.plates.bottom->height = 5e-324; }},
    {"bottom amplitude",
     [](Scene& s) { s.plates.bottom->amplitude = next(s.plates.bottom->amplitude); }},
    {"bottom period", [](Scene& s) { s.plates.bottom->period = next(s.plates.bottom->period); }},
    {"no lid", [](Scene& s) { s.plates.lid = std::monostate{}; }},
    {"prescribed lid", [](Scene& s) { s.plates.lid = scene::PrescribedPlate{.height = 5.2}; }},
    {"lid mass", [](Scene& s) { free_lid(s).mass = next(free_lid(s).mass); }},
    {"lid height", [](Scene& s) { free_lid(s).height = next(free_lid(s).height); }},
    {"lid velocity", [](Scene& s) { free_lid(s).velocity = 5e-324; }},
    {"gravity", [](Scene& s) { s.gravity = next(s.gravity); }},
    {"period along x", [](Scene& s) { s.periodic_x = next(*s.periodic_x); }},
    {"open along x", [](Scene& s) { s.periodic_x.reset(); }},
    {"period along y", [](Scene& s) { s.periodic_y = next(*s.periodic_y); }},
    {"open along y", [](Scene& s) { s.periodic_y.reset(); }},
    {"integrator", [](Scene& s) { s.integrator = scene::Integrator::verlet_predicted; }},
    {"another integrator", [](Scene& s) { s.integrator = scene::Integrator::taguchi_euler; }},
    {"contacts", [](Scene& s) { s.contacts = scene::Contacts::lattice_neighbours; }},
    {"precision", [](Scene& s) { s.precision = scene::Precision::mixed; }},
    {"bottom phase", [](Scene& s) { s.plates.bottom->phase = 0.25; }},
    {"dt", [](Scene& s) { s.dt = next(s.dt); }},
    {"steps", [](Scene& s) { s.steps += s.frame_every; }},
    {"frame_every", [](Scene& s) { s.frame_every /= 2; }},
    {"seed", [](Scene& s) { s.seed += std::uint64_t{1} << 60; }},
    {"x", [](Scene& s) { s.initial.x[7] = next(s.initial.x[7]); }},
    {"y", [](Scene& s) { s.initial.y[7] = next(s.initial.y[7]); }},
    {"vx", [](Scene& s) { s.initial.vx.back() = next(s.initial.vx.back()); }},
    {"vy", [](Scene& s) { s.initial.vy.front() = next(s.initial.vy.front()); }},
    {"a grain more", [](Scene& s) { tests::add_grain(s, 0, 50, 0, 0); }},
    {"order of grains", [](Scene& s) { std::swap(s.initial.x[0], s.initial.x[1]); }},
    {"frozen", [](Scene& s) { s.initial.frozen[0] = true; }},
    {"nothing frozen", [](Scene& s) { s.initial.frozen.clear(); }},
    {"drag", [](Scene& s) { s.drag = 5e-324; }},
    {"backing", [](Scene& s) { s.backing = scene::BackingPlanes{.stiffness = 1, .right = 1}; }},
    {"backing's place",
     [](Scene& s) { s.backing = scene::BackingPlanes{.stiffness = 1, .right = 2}; }},
    {"damping scale",
     [](Scene& s) { s.contact.damping_scale = scene::DampingScale::effective_mass; }},
    {"friction", [](Scene& s) { s.contact.friction = scene::Friction{}; }},
    {"dashpot",
     [](Scene& s) {
         s.contact.friction = scene::Friction{.force = scene::TangentialForce::dashpot};
     }},
    {"coefficient", [](Scene& s) { s.contact.friction = scene::Friction{.coefficient = 1}; }},
    {"tangential stiffness",
     [](Scene& s) { s.contact.friction = scene::Friction{.stiffness = 1}; }},
    {"tangential damping", [](Scene& s) { s.contact.friction = scene::Friction{.damping = 1}; }},
    {"inertia", [](Scene& s) { s.contact.friction = scene::Friction{.inertia_factor = 0.4}; }},
    {"conventions",
     [](Scene& s) {
         s.contact.friction = scene::Friction{.conventions = scene::FrictionConventions{}};
     }},
    {"other conventions",
     [](Scene& s) {
         s.contact.friction =
             scene::Friction{.conventions = scene::conventions_named("lammps-granular")};
     }},
    {"omega", [](Scene& s) { s.initial.omega.assign(s.grain_count(), 0); }},
    {"a spin",
     [](Scene& s) {
         s.initial.omega.assign(s.grain_count(), 0);
         s.initial.omega[3] = 5e-324;
     }},
    {"sizes",
     [](Scene& s) {
         s.grains.diameters.assign(s.grain_count(), s.grains.diameter);
         s.grains.masses.assign(s.grain_count(), s.grains.mass);
     }},
    {"a size",
     [](Scene& s) {
         s.grains.diameters.assign(s.grain_count(), s.grains.diameter);
         s.grains.masses.assign(s.grain_count(), s.grains.mass);
         s.grains.diameters[2] = next(s.grains.diameters[2]);
     }},
    {"a mass",
     [](Scene& s) {
         s.grains.diameters.assign(s.grain_count(), s.grains.diameter);
         s.grains.masses.assign(s.grain_count(), s.grains.mass);
         s.grains.masses[2] = next(s.grains.masses[2]);
     }},
    {"preparation",
     [](Scene& s) { s.preparation = scene::Preparation{.steps = 1, .removed = {}}; }}};

}  // namespace

BOOST_AUTO_TEST_CASE(every_field_changes_the_text_and_each_in_its_own_way) {
    std::set<std::string> texts{text_of(full_scene())};
    for (const auto& mutation : mutations) {
        auto changed = full_scene();
        mutation.apply(changed);
        BOOST_TEST_CONTEXT(mutation.what) {
            BOOST_TEST(texts.insert(text_of(changed)).second);
        }
    }
}

BOOST_AUTO_TEST_CASE(usual_choices_are_not_written_so_that_older_scenes_keep_their_text) {
    const std::string text = text_of(full_scene());
    for (const char* key : {"contacts", "precision", "phase", "drag", "backing", "damping_scale",
                            "friction", "omega", "diameters", "masses", "preparation"})
        BOOST_TEST(text.find(std::string("\"") + key + '"') == std::string::npos, key);
}

BOOST_AUTO_TEST_CASE(the_same_scene_gives_the_same_text) {
    BOOST_TEST(text_of(full_scene()) == text_of(full_scene()));
    BOOST_TEST(text_of(tests::small_gas()) == text_of(tests::small_gas()));
}

BOOST_AUTO_TEST_CASE(keys_are_in_a_fixed_order_whatever_is_set) {
    const auto keys_of = [](const Scene& s) {
        const auto json = scene::to_json(s);
        std::vector<std::string> keys;
        for (auto entry = json.begin(); entry != json.end(); ++entry)
            keys.push_back(entry.key());
        return keys;
    };
    BOOST_TEST(keys_of(full_scene()) == keys_of(tests::head_on_pair()),
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(numbers_read_back_to_the_same_bits) {
    auto s = full_scene();
    s.initial.x[0] = 0.1 + 0.2;
    s.initial.x[1] = 5e-324;
    s.initial.x[2] = -1.7976931348623157e308;
    s.seed = 18446744073709551615U;
    const auto read = nlohmann::json::parse(text_of(s));
    BOOST_TEST(read["initial"]["x"].get<std::vector<double>>() == s.initial.x,
               boost::test_tools::per_element());
    BOOST_TEST(read["initial"]["vy"].get<std::vector<double>>() == s.initial.vy,
               boost::test_tools::per_element());
    BOOST_TEST(read["contact"]["stiffness"].get<double>() == s.contact.stiffness);
    BOOST_TEST(read["seed"].get<std::uint64_t>() == s.seed);
    BOOST_TEST(read.dump() == text_of(s));
}

BOOST_AUTO_TEST_CASE(what_a_scene_lacks_is_null) {
    const auto json = scene::to_json(tests::head_on_pair());
    BOOST_TEST(json["periodic_x"].is_null());
    BOOST_TEST(json["plates"]["bottom"].is_null());
    BOOST_TEST(json["plates"]["lid"].is_null());
}

BOOST_AUTO_TEST_CASE(settings_show_what_a_reader_of_a_report_asks_for) {
    const auto settings = scene::settings_json(tests::small_bed());
    BOOST_TEST(settings["dt"].get<double>() == 1e-4);
    BOOST_TEST(settings["grains"].get<int>() == 18);
    BOOST_TEST(settings["damping"].get<std::string>() == "full-vector");
    BOOST_TEST(settings["clipping"].get<std::string>() == "none");
    BOOST_TEST(settings["integrator"].get<std::string>() == "verlet-half-step");
    BOOST_TEST(settings["plates_touch"].get<std::string>() == "centre");
    BOOST_TEST(!scene::settings_json(tests::small_gas()).contains("plates_touch"));
    // A lid alone is a plate, too.
    BOOST_TEST(scene::settings_json(tests::free_lid_collision()).contains("plates_touch"));
}
