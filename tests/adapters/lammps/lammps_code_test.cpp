// Real runs of LAMMPS: the suite of its family, and what is particular to it.
#include "adapters/lammps/lammps_code.hpp"
#include "tests/support/external_code.hpp"
#include "tests/support/lammps_family_suite.hpp"
#include "tests/support/parity.hpp"
#include "tests/support/scenes.hpp"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace crossgrain;
using adapters::LammpsCode;

using NeedsLammps = tests::NeedsCode<LammpsCode>;
BOOST_TEST_GLOBAL_FIXTURE(NeedsLammps);

const adapters::GrainCode& tests::code_under_test() {
    static const LammpsCode code;
    return code;
}

BOOST_AUTO_TEST_CASE(version_is_what_the_program_says) {
    const auto availability = LammpsCode().probe();
    BOOST_TEST_MESSAGE("LAMMPS " << availability.version);
    // "29 Sep 2021 - Update 2" or "2 Aug 2023"
    BOOST_TEST(availability.version.find(" 20") != std::string::npos);
    BOOST_TEST(availability.reason.empty());
    BOOST_TEST(LammpsCode("crossgrain-no-such-lmp").probe().reason ==
               "no 'crossgrain-no-such-lmp' on PATH");
}

BOOST_AUTO_TEST_CASE(another_program_is_no_lammps) {
    const auto availability = LammpsCode("true").probe();
    BOOST_TEST(!availability.installed);
    BOOST_TEST(availability.reason == "'true -h' does not name a version of LAMMPS");
}

BOOST_AUTO_TEST_CASE(spins_are_expressed_only_where_nothing_turns_a_grain) {
    auto spinning = tests::oblique_pair();
    spinning.contact.spins = scene::Spins::on;
    BOOST_TEST(LammpsCode().cannot_express(spinning).has_value());
    // Without a tangential dashpot nothing turns a grain.
    tests::check_parity(LammpsCode(), tests::with_law(spinning, scene::Damping::normal_only,
                                                      scene::Clipping::none));
}
