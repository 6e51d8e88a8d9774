// A store that cannot be opened, read or written says so in one line that names the directory.
#include "reports/store/store.hpp"

#include "tests/reports/store/stored_run.hpp"
#include "tests/support/temporary_directory.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

using namespace crossgrain;
using store::Store;
using store::StoreError;
using tests::stored_run;
using tests::TemporaryDirectory;

namespace {

template <class Operation>
std::string failure(Operation operation) {
    try {
        operation();
    } catch (const StoreError& error) {
        const std::string line = error.what();
        BOOST_TEST(line.find('\n') == std::string::npos, line);
        return line;
    }
    BOOST_ERROR("no StoreError");
    return {};
}

std::string failure_to_open(const std::filesystem::path& directory) {
    const std::string line = failure([&] { Store results(directory); });
    BOOST_TEST(line.find(directory.string()) != std::string::npos, line);
    return line;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_missing_directory_is_made) {
    const TemporaryDirectory directory;
    const auto deep = directory.path() / "a" / "b";
    Store results(deep);
    BOOST_TEST(results.directory() == deep);
    BOOST_TEST(std::filesystem::exists(deep / "crossgrain.db"));
}

BOOST_AUTO_TEST_CASE(a_directory_that_cannot_be_made_is_refused) {
    // Not by its permissions: root may write everywhere.
    const TemporaryDirectory directory;
    std::ofstream(directory.path() / "file") << "x";
    (void)failure_to_open(directory.path() / "file" / "results");
    (void)failure_to_open(directory.path() / "file");
    if (std::filesystem::exists("/proc/self")) (void)failure_to_open("/proc/results");
}

BOOST_AUTO_TEST_CASE(a_database_that_cannot_be_opened_is_refused) {
    const TemporaryDirectory directory;
    std::filesystem::create_directory(directory.path() / "crossgrain.db");
    (void)failure_to_open(directory.path());
}

BOOST_AUTO_TEST_CASE(a_file_that_is_no_database_is_refused_and_left_alone) {
    const TemporaryDirectory directory;
    const std::string text(5000, 'x');
    std::ofstream(directory.path() / "crossgrain.db") << text;
    const std::string line = failure_to_open(directory.path());
    BOOST_TEST(line.find("not a database") != std::string::npos, line);
    std::ifstream file(directory.path() / "crossgrain.db");
    const std::string now(std::istreambuf_iterator<char>(file), {});
    BOOST_TEST((now == text));
}

BOOST_AUTO_TEST_CASE(a_database_of_another_format_is_refused_with_what_to_do) {
    const TemporaryDirectory directory;
    {
        Store results(directory.path());
        (void)results.add(stored_run());
    }
    {
        SQLite::Database file((directory.path() / "crossgrain.db").string(),
                              SQLite::OPEN_READWRITE);
        file.exec("PRAGMA user_version = 99");
    }
    const std::string line = failure_to_open(directory.path());
    BOOST_TEST(line.find("has format 99") != std::string::npos, line);
    BOOST_TEST(line.find("another --results directory") != std::string::npos, line);
}

BOOST_AUTO_TEST_CASE(a_database_of_another_program_is_refused) {
    // Another program's tables are not ours to add to.
    const TemporaryDirectory directory;
    {
        SQLite::Database file((directory.path() / "crossgrain.db").string(),
                              SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
        file.exec("CREATE TABLE run (name TEXT)");
    }
    (void)failure_to_open(directory.path());
}

BOOST_AUTO_TEST_CASE(a_stored_run_that_is_damaged_is_an_error_and_no_result) {
    const TemporaryDirectory directory;
    Store results(directory.path());
    const auto damage = [&](const std::string& assignment) {
        SQLite::Database file((directory.path() / "crossgrain.db").string(),
                              SQLite::OPEN_READWRITE);
        file.exec("UPDATE run SET " + assignment);
    };
    (void)results.add(stored_run());
    damage("results = x'00'");
    (void)failure([&] { (void)results.find("key"); });
    damage("results = x''");
    (void)failure([&] { (void)results.find("key"); });
}

BOOST_AUTO_TEST_CASE(a_seed_that_is_damaged_is_an_error_and_no_result) {
    const TemporaryDirectory directory;
    Store results(directory.path());
    (void)results.add(stored_run());
    {
        SQLite::Database file((directory.path() / "crossgrain.db").string(),
                              SQLite::OPEN_READWRITE);
        file.exec("UPDATE run SET seed = 'x'");
    }
    (void)failure([&] { (void)results.find("key"); });
    (void)failure([&] { (void)results.history(); });
}

BOOST_AUTO_TEST_CASE(a_run_that_cannot_be_stored_leaves_no_half_of_it) {
    const TemporaryDirectory directory;
    Store results(directory.path());
    {
        SQLite::Database file((directory.path() / "crossgrain.db").string(),
                              SQLite::OPEN_READWRITE);
        file.exec("DROP TABLE measurement");
    }
    (void)failure([&] { (void)results.add(stored_run()); });
    BOOST_TEST(!results.find("key").has_value());
}

BOOST_AUTO_TEST_CASE(a_value_that_is_no_number_is_stored_or_refused_by_its_name) {
    const TemporaryDirectory directory;
    Store results(directory.path());
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        const std::string key = bad > 0 ? "infinite" : "no number";
        std::string line;
        try {
            (void)results.add(stored_run(key, bad));
        } catch (const StoreError& error) {
            line = error.what();
        }
        // "NOT NULL constraint failed (is it full or read-only?)" helps nobody.
        BOOST_TEST((line.empty() ? results.find(key).has_value()
                                 : line.find("restitution") != std::string::npos),
                   line);
    }
}

BOOST_AUTO_TEST_CASE(a_picture_whose_parts_do_not_fit_is_refused_by_name) {
    const TemporaryDirectory directory;
    Store results(directory.path());
    const auto refusal = [&](auto spoil) {
        auto run = stored_run();
        spoil(run.results.pictures[0]);
        const std::string line = failure([&] { results.add(run); });
        BOOST_TEST(line.find("space-time") != std::string::npos, line);
    };
    refusal([](measure::Picture& picture) { picture.width = 4; });
    refusal([](measure::Picture& picture) { picture.pixels.clear(); });
    refusal([](measure::Picture& picture) { picture.palette.resize(255); });
    refusal([](measure::Picture& picture) { picture.palette.resize(257); });
    BOOST_TEST(!results.find("key").has_value());
}
