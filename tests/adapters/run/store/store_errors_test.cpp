// A store that cannot be opened, read or written says so in one line that names the directory.
#include "adapters/run/store/store.hpp"

#include "adapters/run/store/database.hpp"

#include "tests/adapters/run/store/stored_run.hpp"
#include "tests/support/temporary_directory.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <sys/stat.h>
#include <unistd.h>

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

/// Root may write everywhere: in this scope we are somebody who may not.
class WithoutPrivileges {
  public:
    WithoutPrivileges() {
        constexpr uid_t nobody = 65534;
        if (was_ == 0) BOOST_TEST_REQUIRE(seteuid(nobody) == 0);
    }
    ~WithoutPrivileges() {
        if (was_ == 0) (void)!seteuid(0);
    }
    WithoutPrivileges(const WithoutPrivileges&) = delete;
    WithoutPrivileges& operator=(const WithoutPrivileges&) = delete;

  private:
    uid_t was_ = geteuid();
};

/// Changes a store behind its back.
void change(const TemporaryDirectory& directory, const std::string& statement) {
    SQLite::Database file((directory.path() / "crossgrain.db").string(), SQLite::OPEN_READWRITE);
    file.exec(statement);
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
    change(directory, "PRAGMA user_version = 99");
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

BOOST_AUTO_TEST_CASE(a_stored_run_that_is_damaged_is_said_aloud_and_no_result) {
    const TemporaryDirectory directory;
    std::vector<std::string> notes;
    const Store results(directory.path(), store::Access::write,
                        [&](const std::string& line) { notes.push_back(line); });
    const std::string deep(1'000'000, '[');
    for (const std::string& damage :
         {std::string("UPDATE result SET results = x'00'"),
          std::string("UPDATE result SET results = x''"),
          std::string("UPDATE result SET results = replace(hex(zeroblob(500000)), '0', x'81')"),
          std::string("DELETE FROM result"), std::string("UPDATE run SET seed = 'x'"),
          std::string("UPDATE run SET seed = '99999999999999999999'"),
          "UPDATE run SET settings = '" + deep + "'"}) {
        {
            Store writer(directory.path());
            (void)writer.add(stored_run());
        }
        BOOST_TEST(results.find("key").has_value());
        notes.clear();
        change(directory, damage);
        BOOST_TEST(!results.find("key").has_value());
        BOOST_TEST_REQUIRE(notes.size() == 1u);
        BOOST_TEST(notes[0].find("is damaged and not used") != std::string::npos, notes[0]);
    }
}

BOOST_AUTO_TEST_CASE(history_leaves_out_what_is_damaged_and_says_so) {
    const TemporaryDirectory directory;
    std::vector<std::string> notes;
    Store results(directory.path(), store::Access::write,
                  [&](const std::string& line) { notes.push_back(line); });
    (void)results.add(stored_run("a"));
    (void)results.add(stored_run("b"));
    change(directory, "UPDATE run SET seed = 'x' WHERE key = 'a'");
    BOOST_TEST(results.history().size() == 3u);
    BOOST_TEST_REQUIRE(notes.size() == 1u);
    BOOST_TEST(notes[0] == "2 stored measurements are damaged and left out");
}

BOOST_AUTO_TEST_CASE(a_full_disk_and_a_read_only_one_are_told_apart) {
    const TemporaryDirectory directory;
    Store results(directory.path());
    (void)results.add(stored_run());
    // As many pages as there are, and no more: what SQLite says of a full disk.
    auto run = stored_run("large");
    run.log_tail = std::string(10'000'000, 'x');
    change(directory, "PRAGMA user_version = 2");
    store::Database full(directory.path(), store::Access::write, {});
    full.sqlite().exec("PRAGMA max_page_count = 10");
    const std::string line = failure([&] {
        full.guarded([&] { full.sqlite().exec("CREATE TABLE x AS SELECT zeroblob(1000000)"); });
    });
    BOOST_TEST(line.find("the disk is full") != std::string::npos, line);
    const store::Database reader(directory.path(), store::Access::read, {});
    const std::string refused =
        failure([&] { reader.guarded([&] { reader.sqlite().exec("CREATE TABLE y (z TEXT)"); }); });
    BOOST_TEST(refused.find("cannot be written") != std::string::npos, refused);
}

BOOST_AUTO_TEST_CASE(a_store_that_is_only_read_must_be_there) {
    const TemporaryDirectory directory;
    const auto missing = directory.path() / "mistyped";
    const std::string line = failure([&] { const Store results(missing, store::Access::read); });
    BOOST_TEST(line.find("does not exist") != std::string::npos, line);
    BOOST_TEST(line.find("--results") != std::string::npos, line);
    BOOST_TEST(!std::filesystem::exists(missing));
    BOOST_TEST(Store(missing, store::Access::read_if_there).history().empty());
    BOOST_TEST(!std::filesystem::exists(missing));
    // Without anything in it, it is empty, and stays so.
    const Store empty(directory.path(), store::Access::read);
    BOOST_TEST(!empty.find("key").has_value());
    BOOST_TEST(empty.history().empty());
    BOOST_TEST(std::filesystem::is_empty(directory.path()));
}

BOOST_AUTO_TEST_CASE(a_file_in_a_directory_without_write_permission_is_read) {
    namespace fs = std::filesystem;
    const TemporaryDirectory directory;
    const auto odd = directory.path() / "100% of ? and #";
    {
        Store results(odd);
        (void)results.add(stored_run());
    }
    constexpr auto all_may_read =
        fs::perms::all &
        ~(fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write);
    for (const auto& path : {directory.path(), odd})
        fs::permissions(path, all_may_read);
    {
        const WithoutPrivileges nobody;
        BOOST_TEST(Store(odd, store::Access::read).find("key").has_value());
        const std::string line = failure([&] { const Store results(odd); });
        BOOST_TEST(line.find("permission") != std::string::npos, line);
    }
    for (const auto& path : {directory.path(), odd})
        fs::permissions(path, fs::perms::owner_all);
}

BOOST_AUTO_TEST_CASE(a_store_for_later_is_made_when_it_is_used) {
    const TemporaryDirectory directory;
    const auto later = directory.path() / "results";
    const Store results(later, store::Access::write_later);
    BOOST_TEST(!std::filesystem::exists(later));
    BOOST_TEST(!results.find("key").has_value());
    BOOST_TEST(std::filesystem::exists(later / "crossgrain.db"));
}

BOOST_AUTO_TEST_CASE(what_is_no_regular_file_is_not_opened) {
    const TemporaryDirectory directory;
    const auto file = directory.path() / "crossgrain.db", target = directory.path() / "elsewhere";
    BOOST_TEST_REQUIRE(mkfifo(file.c_str(), 0600) == 0);
    for (const auto access : {store::Access::read, store::Access::write}) {
        const std::string line = failure([&] { const Store results(directory.path(), access); });
        BOOST_TEST(line.find("no regular file") != std::string::npos, line);
    }
    std::filesystem::remove(file);
    std::filesystem::create_symlink(target, file);
    (void)failure_to_open(directory.path());
    BOOST_TEST(!std::filesystem::exists(target));
}

BOOST_AUTO_TEST_CASE(a_run_that_cannot_be_stored_leaves_no_half_of_it) {
    const TemporaryDirectory directory;
    Store results(directory.path());
    change(directory, "DROP TABLE measurement");
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
