// Protects what a call leaves for people to look at, with and without pages in the build: the file
// that is named exists and holds the document; a directory that cannot be made is an error.
#include "reports/web/pages.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <fstream>
#include <string>
#include <system_error>

using namespace crossgrain;
using nlohmann::json;
using reports::Page;
namespace fs = std::filesystem;

namespace {

run::Execution settings_in(const fs::path& results) {
    run::Execution settings;
    settings.results = results;
    return settings;
}

/// Where a page has its data from.
fs::path data_of(Page page, const run::Execution& settings) {
    if (CROSSGRAIN_PAGES == 0) return page_file(page, settings);
    const char* names[] = {"data.js", "charts-data.js", "stability-data.js"};
    return settings.results / "report" / names[static_cast<int>(page)];
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_file_that_is_named_is_there_and_its_data_too) {
    const tests::TemporaryDirectory directory;
    const auto settings = settings_in(directory.path());
    for (const Page page : {Page::report, Page::charts, Page::stability}) {
        write_page(page, {{"version", "a version to be found"}}, settings);
        BOOST_TEST(fs::is_regular_file(page_file(page, settings)));
        std::ifstream in(data_of(page, settings));
        const std::string text((std::istreambuf_iterator<char>(in)), {});
        BOOST_TEST(text.find("a version to be found") != std::string::npos);
        BOOST_TEST(page_file(page, settings).extension() ==
                   (CROSSGRAIN_PAGES != 0 ? ".html" : ".json"));
    }
}

BOOST_AUTO_TEST_CASE(a_directory_that_cannot_be_made_is_an_error) {
    const tests::TemporaryDirectory directory;
    std::ofstream(directory.path() / "report") << "a file in the way";
    BOOST_CHECK_THROW(write_page(Page::charts, {}, settings_in(directory.path())),
                      std::system_error);
}
