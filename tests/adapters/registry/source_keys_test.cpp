// What a change of our sources computes again: the runs that depend on them, and no others.
#include "adapters/registry/codes.hpp"
#include "adapters/registry/source_keys.hpp"
#include "cases/observables/observables.hpp"

#include <boost/test/unit_test.hpp>

#include <array>
#include <stdexcept>

using namespace crossgrain;
using adapters::SourceFolder;

namespace {

constexpr std::array<SourceFolder, 4> table{{{"engine", "e", "base"},
                                             {"estimator", "m", "statistics base"},
                                             {"statistics", "s", "base"},
                                             {"base", "b", ""}}};

/// The key of an estimator with another digest of one folder.
std::string changed(const std::string& folder) {
    auto other = table;
    for (auto& row : other) {
        if (row.folder == folder) row.digest = "other";
    }
    return source_key(other, {"estimator"});
}

std::set<std::string> sources_of(const std::string& the_case) {
    const auto folders = observables::source_folders(
        catalog::load_case(CROSSGRAIN_SOURCE_DIR "/cases/catalog/" + the_case + ".toml",
                           catalog::Suite::full, CROSSGRAIN_SOURCE_DIR "/cases/catalog/readings"));
    return with_needs(adapters::built_sources(), folders);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_key_changes_with_what_is_needed_and_with_nothing_else) {
    const std::string before = source_key(table, {"estimator"});
    BOOST_TEST(changed("estimator") != before);
    BOOST_TEST(changed("statistics") != before);
    BOOST_TEST(changed("base") != before);
    BOOST_TEST(changed("engine") == before);
    BOOST_CHECK_THROW((void)source_key(table, {"nowhere"}), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(every_code_has_sources_of_its_own) {
    std::set<std::string> keys;
    for (const auto* code : adapters::codes())
        keys.insert(adapters::code_source_key(code->name()));
    BOOST_TEST(keys.size() == adapters::codes().size());
    BOOST_CHECK_THROW((void)adapters::code_source_key("nobody"), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(foreign_codes_do_not_depend_on_engines_or_estimators) {
    for (const char* code : {"adapters/lammps", "adapters/liggghts", "adapters/yade"}) {
        const auto sources = with_needs(adapters::built_sources(), {code});
        for (const char* needed : {"adapters/dump", "adapters/program", "cases/scene"})
            BOOST_TEST(sources.contains(needed), code << " needs " << needed);
        for (const auto& folder : sources) {
            BOOST_TEST(!folder.starts_with("cases/measure"), code << " needs " << folder);
            BOOST_TEST((folder == "native/base" || !folder.starts_with("native/")),
                       code << " needs " << folder);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_pipe_does_not_depend_on_the_estimators_of_a_bed) {
    const auto pipe = sources_of("pipe-grains"), bed = sources_of("bed-fluid");
    BOOST_TEST(pipe.contains("cases/measure/pipe"));
    BOOST_TEST(pipe.contains("cases/measure/waves"));
    BOOST_TEST(!pipe.contains("cases/measure/gas"));
    BOOST_TEST(!pipe.contains("cases/measure/bed"));
    BOOST_TEST(bed.contains("cases/measure/bed"));
    BOOST_TEST(!bed.contains("cases/measure/pipe"));
    BOOST_TEST(!bed.contains("cases/measure/waves"));
    BOOST_TEST(bed.contains("cases/measure/statistics"));
}
