// Every case that is shipped loads in both suites and is what a case of the catalogue has to be.
#include "cases/catalog/case.hpp"

#include "tests/cases/toml/refusal.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

using namespace crossgrain;
using catalog::Suite;

namespace {

const std::string directory = CROSSGRAIN_SOURCE_DIR "/cases/catalog";

template <class Check>
void for_every_case(Check check) {
    for (const auto& name : catalog::case_names(directory)) {
        for (const auto suite : {Suite::quick, Suite::full}) {
            BOOST_TEST_CONTEXT(name << (suite == Suite::quick ? ", quick" : ", full")) {
                check(catalog::find_case(directory, name, suite));
            }
        }
    }
}

bool holds(const std::vector<std::string>& words, const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_shipped_case_loads_in_both_suites) {
    const auto names = catalog::case_names(directory);
    BOOST_TEST(names.size() >= 6u);
    BOOST_TEST(std::is_sorted(names.begin(), names.end()));
    for (const auto& name : names) {
        for (const auto suite : {Suite::quick, Suite::full})
            BOOST_CHECK_NO_THROW((void)catalog::find_case(directory, name, suite));
    }
}

BOOST_AUTO_TEST_CASE(a_case_is_named_like_its_file_and_says_what_it_is) {
    for_every_case([](const catalog::Case& c) {
        BOOST_TEST(c.name == std::filesystem::path(c.file).stem().string());
        BOOST_TEST(!c.title.empty());
        BOOST_TEST(!c.source.empty());
        BOOST_TEST(!c.text.empty());
        for (const auto& suite : c.suites)
            BOOST_TEST((suite == "quick" || suite == "full" || suite == "chart"), suite);
        BOOST_TEST(!c.observables.empty());
        // A map of states over a sweep is read, not judged.
        const bool is_map = c.variants.size() > 1;
        BOOST_TEST((is_map || !c.checks.empty()));
        BOOST_TEST((is_map || !c.suites.empty()));
    });
}

BOOST_AUTO_TEST_CASE(variants_of_a_case_have_names_of_their_own) {
    for_every_case([](const catalog::Case& c) {
        std::set<std::string> names;
        for (const auto& variant : c.variants)
            BOOST_TEST(names.insert(variant.name).second, "twice: '" << variant.name << "'");
    });
}

BOOST_AUTO_TEST_CASE(a_failure_map_is_a_case_of_the_same_model) {
    const auto names = catalog::case_names(directory);
    for_every_case([&](const catalog::Case& c) {
        if (c.failure_map.empty()) return;
        BOOST_TEST_REQUIRE(holds(names, c.failure_map));
        const auto map = catalog::find_case(directory, c.failure_map, Suite::full);
        BOOST_TEST(map.model == c.model);
        BOOST_TEST(map.variants.size() > 1u);
    });
}

/// That the full size has every variant a check names, the reader itself demands.
BOOST_AUTO_TEST_CASE(the_quick_size_leaves_some_check_to_be_asked) {
    for (const auto& name : catalog::case_names(directory)) {
        const auto c = catalog::find_case(directory, name, Suite::quick);
        if (!holds(c.suites, "quick") || c.checks.empty()) continue;
        const bool asked = std::any_of(c.checks.begin(), c.checks.end(), [&](const auto& check) {
            return check.variants.empty() ||
                   std::any_of(c.variants.begin(), c.variants.end(), [&](const auto& variant) {
                       return std::any_of(check.variants.begin(), check.variants.end(),
                                          [&](const auto& pattern) {
                                              return catalog::matches(pattern, variant.name);
                                          });
                   });
        });
        BOOST_TEST(asked, name);
    }
}

BOOST_AUTO_TEST_CASE(checks_against_something_say_what_it_is) {
    for_every_case([](const catalog::Case& c) {
        for (const auto& check : c.checks) {
            const auto text = to_string(check.against);
            if (check.kind == catalog::CheckKind::exact) {
                BOOST_TEST(text.starts_with("analytic:"), text);
            } else if (check.kind == catalog::CheckKind::published) {
                BOOST_TEST(text.starts_with("published:"), text);
            } else {
                BOOST_TEST(text.empty(), text);
            }
        }
    });
}

BOOST_AUTO_TEST_CASE(every_scene_of_every_case_starts_without_contacts) {
    for_every_case([](const catalog::Case& c) {
        for (std::size_t v = 0; v < c.variants.size(); ++v) {
            for (std::size_t rung = 0; rung < c.variants[v].rungs; ++rung) {
                if (c.model != "grains") continue;
                const auto scene = c.grain_scene(v, rung, 3);
                BOOST_TEST(scene::initial_contacts(scene) == 0u);
                BOOST_TEST(scene.grain_count() > 0u);
                BOOST_TEST(scene.steps % scene.frame_every == 0);
                BOOST_TEST(scene.name.starts_with(c.name));
            }
        }
    });
}

BOOST_AUTO_TEST_CASE(an_unknown_name_gets_the_nearest_one_as_a_hint) {
    const auto e =
        tests::refusal([] { (void)catalog::find_case(directory, "colision-normal", Suite::full); });
    BOOST_TEST(e.problem == "unknown case");
    BOOST_TEST(e.got == "'colision-normal'");
    BOOST_TEST(e.hint == "did you mean 'collision-normal'?");
    const auto far =
        tests::refusal([] { (void)catalog::find_case(directory, "weather", Suite::full); });
    BOOST_TEST(far.hint.empty());
}

BOOST_AUTO_TEST_CASE(a_path_is_read_as_a_file) {
    const auto c = catalog::find_case("nowhere", directory + "/gas-parity.toml", Suite::full);
    BOOST_TEST(c.name == "gas-parity");
    const auto e =
        tests::refusal([] { (void)catalog::find_case(directory, "missing.toml", Suite::full); });
    BOOST_TEST(e.file == "missing.toml");
    BOOST_TEST(e.problem == "cannot be read");
}
