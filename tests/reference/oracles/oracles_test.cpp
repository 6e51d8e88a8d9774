// Protects the catalogue: every oracle, code and observable named by a shipped case exists, and the
// oracles give the known numbers for the shipped scenes.
#include "adapters/registry/codes.hpp"
#include "adapters/run/case_names.hpp"
#include "native/base/errors.hpp"
#include "reference/oracles/oracles.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <string>

using namespace crossgrain;

namespace {

const std::string catalogue = CROSSGRAIN_SOURCE_DIR "/cases/catalog";

catalog::Case shipped(const std::string& name) {
    return catalog::find_case(catalogue, name, catalog::Suite::full);
}

}  // namespace

BOOST_AUTO_TEST_CASE(shipped_cases_name_only_what_exists) {
    for (const auto& name : catalog::case_names(catalogue)) {
        const auto the_case = shipped(name);
        BOOST_CHECK_NO_THROW(run::check_names(the_case));
        for (const auto& check : the_case.checks) {
            if (check.kind != catalog::CheckKind::exact) continue;
            const auto scene = the_case.scene(0, 0, 1);
            const auto against = to_string(check.against);
            const bool known = oracles::exact_value(against, scene).has_value();
            BOOST_TEST(known, name << ": " << against);
        }
    }
}

BOOST_AUTO_TEST_CASE(restitution_of_the_shipped_variants) {
    const auto the_case = shipped("collision-normal");
    const auto value = [&](std::size_t variant) {
        return oracles::exact_value("analytic:restitution", the_case.grain_scene(variant, 0, 1))
            .value();
    };
    // full: by construction; clipped: 0.80809934 head-on for e = 0.8; frozen: mu = m instead of
    // m/2.
    BOOST_TEST(value(0) == 0.8, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(value(1) == 0.80809934, boost::test_tools::tolerance(1e-8));
    BOOST_TEST(value(2) == value(1), boost::test_tools::tolerance(1e-14));
    BOOST_TEST(value(3) > value(0));
}

BOOST_AUTO_TEST_CASE(pairs_of_unequal_size_have_their_own_reduced_mass) {
    const auto the_case = shipped("size-ratio");
    const auto value = [&](const std::string& oracle, std::size_t variant) {
        return oracles::exact_value(oracle, the_case.grain_scene(variant, 0, 1));
    };
    // The contact time grows as the root of the reduced mass, from 0.1 of two equal discs; turning
    // the normal off centre changes it by some parts in a thousand.
    const auto off_centre = boost::test_tools::tolerance(5e-3);
    BOOST_TEST(value("analytic:contact_time", 1).value() == 0.1 * std::sqrt(2 * 27.0 / 28),
               off_centre);
    BOOST_TEST(value("analytic:contact_time", 3).value() == 0.1 * std::sqrt(2 * 1000.0 / 1001),
               off_centre);
    // Dashpots are per effective mass: ln e is proportional to the contact time.
    BOOST_TEST(std::log(value("analytic:restitution", 0).value()) ==
                   std::log(0.8) * std::sqrt(2 * 27.0 / 28),
               boost::test_tools::tolerance(2e-2));
    BOOST_TEST(value("analytic:restitution", 1).value() == 1.0, boost::test_tools::tolerance(1e-9));
    // With friction there is none.
    BOOST_TEST(!value("analytic:restitution", 4).has_value());
    BOOST_TEST(!value("analytic:contact_time", 4).has_value());
}

BOOST_AUTO_TEST_CASE(unknown_names_are_refused_with_a_hint) {
    const auto is_hint = [](const CaseError& error) {
        return !error.details().hint.empty() && !error.details().expected.empty();
    };
    BOOST_CHECK_EXCEPTION((void)adapters::select_codes({"lamps"}), CaseError, is_hint);
    auto the_case = shipped("gas-parity");
    the_case.observables[0].name = "trajectori";
    BOOST_CHECK_EXCEPTION(run::check_names(the_case), CaseError, is_hint);
    the_case = shipped("gas-parity");
    the_case.checks[0].limit_for["yad"] = 1;
    BOOST_CHECK_EXCEPTION(run::check_names(the_case), CaseError, is_hint);
}
