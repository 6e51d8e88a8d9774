#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <system_error>

#include <boost/test/unit_test.hpp>
#include <unistd.h>

#include "adapters/run/store/packed_bytes.hpp"
#include "native/base/errors.hpp"
#include "reports/documents/atomic_file.hpp"
#include "reports/web/document_parts.hpp"
#include "reports/web/web_report.hpp"

namespace fs = std::filesystem;
using namespace crossgrain;
using nlohmann::json;

namespace {

/// A fresh folder that disappears with the test.
struct Folder {
    fs::path path = fs::temp_directory_path() / ("crossgrain-web-" + std::to_string(::getpid()));
    Folder() {
        fs::remove_all(path);
        fs::create_directories(path);
    }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    fs::path assets() const {
        for (const char* name : {"index.html", "history.html", "charts.html", "stability.html",
                                 "style.css", "plotly-cartesian.min.js", "summary.js"})
            reports::write_file_atomically(path / "assets" / name, name);
        return path / "assets";
    }
};

std::string read(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

std::string data_script(const json& document) {
    return reports::script("window.crossgrainReport", document);
}

/// The document as a script engine would read it back.
json parsed(const std::string& script) {
    const std::string head = "window.crossgrainReport = ";
    BOOST_TEST_REQUIRE(script.starts_with(head));
    BOOST_TEST_REQUIRE(script.ends_with(";\n"));
    return json::parse(script.substr(head.size(), script.size() - head.size() - 2));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(scripts)

BOOST_AUTO_TEST_CASE(cannot_end_a_script_element_or_a_line) {
    const json document = {{"log_tail", "</script><!-- \xE2\x80\xA8 \xE2\x80\xA9 'quotes' \"\\"}};
    const std::string script = data_script(document);
    BOOST_TEST(script.find('<') == std::string::npos);
    for (const char c : script)
        BOOST_TEST_REQUIRE(static_cast<unsigned char>(c) < 0x80);
    BOOST_TEST(script.find('\n') == script.size() - 1);
    BOOST_TEST(parsed(script) == document);
}

BOOST_AUTO_TEST_CASE(survives_bytes_that_are_no_text) {
    const std::string script = data_script({{"log_tail", "broken \xff\xfe bytes"}});
    BOOST_TEST(script.find("\\ufffd") != std::string::npos);
    BOOST_TEST(parsed(script).contains("log_tail"));
}

BOOST_AUTO_TEST_CASE(numbers_that_are_not_finite_become_null_and_others_keep_all_digits) {
    const json document = {{"nan", std::nan("")},
                           {"infinite", std::numeric_limits<double>::infinity()},
                           {"third", 1.0 / 3.0}};
    const json back = parsed(data_script(document));
    BOOST_TEST(back["nan"].is_null());
    BOOST_TEST(back["infinite"].is_null());
    BOOST_TEST(back["third"].get<double>() == 1.0 / 3.0);  // shortest form reads back exactly
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(write_web_report)

BOOST_AUTO_TEST_CASE(copies_assets_and_writes_data_over_an_older_report) {
    const Folder folder;
    const fs::path report = folder.path / "a" / "report";
    reports::write_web_report({{"version", "old"}}, report, folder.assets());
    reports::write_web_report({{"version", "new"}}, report, folder.assets());
    BOOST_TEST(read(report / "index.html") == "index.html");
    BOOST_TEST(read(report / "summary.js") == "summary.js");
    BOOST_TEST(parsed(read(report / "data.js"))["version"] == "new");
    for (const auto& entry : fs::directory_iterator(report))
        BOOST_TEST(entry.path().extension() != ".tmp");
}

BOOST_AUTO_TEST_CASE(history_series_and_pictures_have_files_of_their_own) {
    const Folder folder;
    const fs::path report = folder.path / "report";
    const auto document = [](const std::string& variant) {
        const json picture{{"name", "p"},   {"title", ""},         {"variant", variant},
                           {"width", 2},    {"height", 1},         {"palette", {{9, 8, 7}}},
                           {"pixels", "x"}, {"code", "native-lga"}};
        json good = picture;
        good["pixels"] = store::pack({0, 0});
        return json{{"cases",
                     {{{"case", "c"},
                       {"pictures", {good, picture}},
                       {"series", {{{"name", "contrast"}, {"columns", {"t", "C"}}}}}}}},
                    {"history", {{"series", {1, 2}}}}};
    };
    reports::write_web_report(document("P/b=.1"), report, folder.assets());
    reports::write_web_report(document("D/b=.1"), report, folder.assets());
    const json overview = parsed(read(report / "data.js"));
    const json& item = overview["cases"][0];
    BOOST_TEST(!overview.contains("history"));
    BOOST_TEST(parsed(read(report / "history-data.js"))["history"]["series"].size() == 2);
    BOOST_TEST(item["pictures"][0]["file"] == "pictures/c-native-lga-D_b=.1-p.png");
    BOOST_TEST(!item["pictures"][0].contains("pixels"));
    BOOST_TEST(fs::exists(report / "pictures/c-native-lga-D_b=.1-p.png"));
    BOOST_TEST(item["pictures"][1].contains("problem"));  // its pixels are damaged
    BOOST_TEST(!item["pictures"][1].contains("file"));
    BOOST_TEST(item["series"].empty());
    BOOST_TEST(item["series_names"]["contrast"] == 1);
    const std::string curves = read(report / item["series_file"].get<std::string>());
    BOOST_TEST(curves.find("contrast") != std::string::npos);
    // Nothing is left of the first report.
    BOOST_TEST(std::distance(fs::directory_iterator(report / "pictures"), {}) == 1);
    BOOST_TEST(std::distance(fs::directory_iterator(report / "series"), {}) == 1);
}

BOOST_AUTO_TEST_CASE(a_document_of_the_wrong_shape_is_no_reason_to_fail) {
    for (const json& document :
         {json{}, json::array(), json{{"cases", 3}}, json{{"cases", {1, "x", nullptr}}},
          json{{"cases", {{{"pictures", {1, {{"name", 2}}}}, {"series", {1, {{"name", 3}}}}}}}}})
        BOOST_CHECK_NO_THROW((void)reports::split(document));
}

BOOST_AUTO_TEST_CASE(missing_assets_are_named) {
    const Folder folder;
    const fs::path assets = folder.assets();
    fs::remove(assets / "plotly-cartesian.min.js");
    BOOST_CHECK_EXCEPTION(reports::write_web_report({}, folder.path / "report", assets), CaseError,
                          [](const CaseError& error) {
                              const std::string text = error.what();
                              return text.find("plotly-cartesian.min.js") != std::string::npos &&
                                     text.find('\n') == std::string::npos;
                          });
    BOOST_TEST(!fs::exists(folder.path / "report" / "data.js"));
}

BOOST_AUTO_TEST_CASE(what_a_killed_process_left_is_removed_and_nothing_else) {
    const Folder folder;
    const fs::path report = folder.path / "report";
    const std::string gone = "data.js.2000000000.tmp";  // above every process id of Linux
    const std::string alive = "other.js." + std::to_string(getpid()) + ".tmp";
    for (const auto& name : {gone, alive, std::string("mine.tmp"), std::string("a.12x.tmp")})
        reports::write_file_atomically(report / name, "text");
    reports::write_web_report({}, report, folder.assets());
    BOOST_TEST(!fs::exists(report / gone));
    for (const auto& name : {alive, std::string("mine.tmp"), std::string("a.12x.tmp")})
        BOOST_TEST(fs::exists(report / name), name);
}

BOOST_AUTO_TEST_CASE(a_folder_that_cannot_be_written_is_named) {
    const Folder folder;
    const fs::path assets = folder.assets();
    reports::write_file_atomically(folder.path / "file", "not a folder");
    const auto names_it = [](const std::system_error& error) {
        return std::string(error.what()).find("file") != std::string::npos;
    };
    BOOST_CHECK_EXCEPTION(reports::write_web_report({}, folder.path / "file" / "report", assets),
                          std::system_error, names_it);
    BOOST_CHECK_EXCEPTION(reports::write_web_report({}, folder.path / "file", assets),
                          std::system_error, names_it);
}

BOOST_AUTO_TEST_SUITE_END()
