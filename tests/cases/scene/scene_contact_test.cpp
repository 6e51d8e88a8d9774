// Stiffness and damping from restitution and contact time, the elastic limit, and every
// contradiction between the two ways to give them.
#include "tests/cases/scene/scene_text.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <string>

namespace tt = boost::test_tools;
using namespace crossgrain;
using tests::check_refusal;
using tests::refusal_with;
using tests::replaced;
using tests::scene_text;

namespace {

scene::Scene with_restitution(const std::string& e) {
    return tests::read_scene(replaced(scene_text, "restitution = 0.8", "restitution = " + e));
}

/// The contact table with k and eta instead of e and t_col.
std::string with_stiffness(const std::string& k, const std::string& eta) {
    return replaced(scene_text, "restitution = 0.8\ncontact_time = 0.1",
                    "stiffness = " + k + "\ndamping_coefficient = " + eta);
}

CaseErrorDetails refusal_of_stiffness(const std::string& k, const std::string& eta) {
    return tests::refusal([&] { (void)tests::read_scene(with_stiffness(k, eta)); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(restitution_and_contact_time_give_the_paper_s_stiffness_and_damping) {
    const auto s = tests::read_scene(scene_text);
    // k = m (omega^2 + (eta/m)^2)/2 and eta = -m ln e/t_col, worked out to 40 digits elsewhere;
    // a few roundings.
    BOOST_TEST(s.contact.stiffness == 495.96987227912376, tt::tolerance(1e-15));
    BOOST_TEST(s.contact.damping == 2.2314355131420975, tt::tolerance(1e-15));
    BOOST_TEST(contact_time(s) == 0.1, tt::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(heavy_grains_are_stiffer_by_their_mass) {
    const auto s = tests::read_scene(replaced(scene_text, "mass = 1.0 }", "mass = 2.5 }"));
    BOOST_TEST(s.contact.stiffness == 2.5 * 495.96987227912376, tt::tolerance(1e-15));
    BOOST_TEST(s.contact.damping == 2.5 * 2.2314355131420975, tt::tolerance(1e-15));
    BOOST_TEST(contact_time(s) == 0.1, tt::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(a_restitution_of_exactly_one_is_elastic) {
    for (const std::string one : {"1", "1.0"}) {
        const auto s = with_restitution(one);
        BOOST_TEST(s.contact.damping == 0.0);
        BOOST_TEST(!std::signbit(s.contact.damping));  // -0 would change the run's key
        BOOST_TEST(s.contact.stiffness == std::pow(10 * std::acos(-1.0), 2) / 2,
                   tt::tolerance(1e-15));
    }
}

BOOST_AUTO_TEST_CASE(a_restitution_outside_zero_to_one_is_refused) {
    for (const std::string bad : {"0", "0.0", "1.2", "-0.5", "1.0000000000000002", "nan", "inf"}) {
        const auto e = refusal_with("restitution = 0.8", "restitution = " + bad);
        check_refusal(e, "contact.restitution", 9, "is out of range");
        BOOST_TEST(e.column == 15);
        BOOST_TEST(e.expected == "a number in (0, 1]");
    }
    check_refusal(refusal_with("restitution = 0.8", "restitution = \"0.8\""), "contact.restitution",
                  9, "has the wrong type");
}

BOOST_AUTO_TEST_CASE(a_contact_time_must_be_positive) {
    for (const std::string bad : {"0", "-0.1"}) {
        check_refusal(refusal_with("contact_time = 0.1", "contact_time = " + bad),
                      "contact.contact_time", 10, "is out of range");
    }
    check_refusal(refusal_with("contact_time = 0.1", ""), "contact.contact_time", 8, "is missing");
}

BOOST_AUTO_TEST_CASE(stiffness_and_damping_may_be_given_directly) {
    const auto s = tests::read_scene(with_stiffness("500", "2.0"));
    BOOST_TEST(s.contact.stiffness == 500.0);
    BOOST_TEST(s.contact.damping == 2.0);
    BOOST_TEST(tests::read_scene(with_stiffness("500", "0")).contact.damping == 0.0);
}

BOOST_AUTO_TEST_CASE(stiffness_and_damping_out_of_range_are_refused) {
    for (const std::string bad : {"-500", "0"}) {
        check_refusal(refusal_of_stiffness(bad, "2"), "contact.stiffness", 9, "is out of range");
    }
    check_refusal(refusal_of_stiffness("500", "-2"), "contact.damping_coefficient", 10,
                  "is out of range");
}

BOOST_AUTO_TEST_CASE(an_overdamped_contact_is_refused) {
    // 2 k/m = (eta/m)^2 at eta = 31.6.
    BOOST_CHECK_NO_THROW((void)tests::read_scene(with_stiffness("500", "31")));
    const auto e = refusal_of_stiffness("500", "32");
    check_refusal(e, "contact", 8, "is overdamped");
    BOOST_TEST(e.got == "eta = 32");
}

BOOST_AUTO_TEST_CASE(restitution_and_stiffness_together_are_a_contradiction) {
    const auto e = refusal_with("contact_time = 0.1", "contact_time = 0.1\nstiffness = 500");
    check_refusal(e, "contact.stiffness", 11, "contradicts");
    BOOST_TEST(e.got.find("scene.contact.restitution") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(half_of_the_other_pair_is_refused) {
    const auto with_eta =
        refusal_with("contact_time = 0.1", "contact_time = 0.1\ndamping_coefficient = 2.0");
    BOOST_TEST(with_eta.key == "scene.contact.damping_coefficient");
    BOOST_TEST(with_eta.line == 11);
    const auto with_time = tests::refusal([] {
        (void)tests::read_scene(
            replaced(with_stiffness("500", "2"), "[contact]", "[contact]\ncontact_time = 0.1"));
    });
    BOOST_TEST(with_time.key == "scene.contact.contact_time");
    BOOST_TEST(with_time.line == 9);
}

BOOST_AUTO_TEST_CASE(neither_restitution_nor_stiffness_is_refused) {
    check_refusal(refusal_with("restitution = 0.8", ""), "contact.restitution", 8, "is missing");
}

BOOST_AUTO_TEST_CASE(the_choices_of_a_law_must_be_made) {
    for (const std::string line :
         {"damping = \"full-vector\"", "clipping = \"none\"", "spins = \"off\""}) {
        const auto e = refusal_with(line, "");
        BOOST_TEST(e.problem == "is missing");
        BOOST_TEST(e.key == "scene.contact." + line.substr(0, line.find(' ')));
    }
    check_refusal(refusal_with("\"none\"", "\"nome\""), "contact.clipping", 12, "is not known");
    check_refusal(refusal_with("\"full-vector\"", "\"full\""), "contact.damping", 11,
                  "is not known");
    check_refusal(refusal_with("\"off\"", "false"), "contact.spins", 13, "has the wrong type");
}
