// Real runs of LIGGGHTS: the suite of its family, and what is particular to it.
#include "adapters/liggghts/liggghts_code.hpp"
#include "tests/support/external_code.hpp"
#include "tests/support/lammps_family_suite.hpp"
#include "tests/support/parity.hpp"
#include "tests/support/scenes.hpp"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace crossgrain;
using adapters::LiggghtsCode;
using scene::Clipping;
using scene::Damping;
using tests::check_parity;
using tests::with_law;

using NeedsLiggghts = tests::NeedsCode<LiggghtsCode>;
BOOST_TEST_GLOBAL_FIXTURE(NeedsLiggghts);

const adapters::GrainCode& tests::code_under_test() {
    static const LiggghtsCode code;
    return code;
}

BOOST_AUTO_TEST_CASE(version_is_what_the_program_says) {
    const auto availability = LiggghtsCode().probe();
    BOOST_TEST_MESSAGE("LIGGGHTS " << availability.version);
    BOOST_TEST(availability.version.find_first_not_of("0123456789.") == std::string::npos);
    BOOST_TEST(availability.reason.empty());
    BOOST_TEST(LiggghtsCode("crossgrain-no-such-liggghts").probe().reason ==
               "no 'crossgrain-no-such-liggghts' on PATH");
}

BOOST_AUTO_TEST_CASE(spinning_grains) {
    const LiggghtsCode code;
    const auto spinning = [](scene::Scene scene) {
        scene.name += "/spins";
        scene.contact.spins = scene::Spins::on;
        return scene;
    };
    for (const double dt : {1e-3, 1e-4}) {
        const auto pair = spinning(tests::oblique_pair(dt));
        check_parity(code, pair);
        check_parity(code, with_law(pair, Damping::full_vector, Clipping::all));
        check_parity(code, with_law(pair, Damping::normal_only, Clipping::none));
        check_parity(code, spinning(tests::frozen_target(dt)));
    }
    check_parity(code, spinning(tests::small_gas()));
    check_parity(code, spinning(tests::heavy_small_gas()));
    check_parity(code, spinning(tests::bed_with_obstacle()));
}
