// What is stored is found again: runs bit for bit by their key, the newest success first, the
// history in order, verdicts with their entry; from several stores on one file.
#include "adapters/run/store/store.hpp"

#include "adapters/run/store/results_json.hpp"
#include "tests/adapters/run/store/stored_run.hpp"
#include "tests/support/temporary_directory.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <thread>
#include <vector>

using namespace crossgrain;
using store::RunRecord;
using store::Store;
using tests::stored_run;

namespace {

RunRecord failed_run(const std::string& key) {
    auto run = stored_run(key);
    run.status = store::RunStatus::run_failed;
    run.reason = "dump ends in the middle of frame 7";
    run.log_tail = "ERROR: lost atoms\nLast command: run 100";
    run.results = {};
    return run;
}

/// A file as earlier programs wrote it, with one run, one measurement, one entry and one verdict.
void write_format_1(const std::filesystem::path& path) {
    SQLite::Database file(path.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    file.exec(R"(
CREATE TABLE run (
    id INTEGER PRIMARY KEY, key TEXT NOT NULL, case_name TEXT NOT NULL, variant TEXT NOT NULL,
    rung INTEGER NOT NULL, code TEXT NOT NULL, version TEXT NOT NULL, replica INTEGER NOT NULL,
    seed TEXT NOT NULL, status TEXT NOT NULL, reason TEXT NOT NULL, log_tail TEXT NOT NULL,
    settings TEXT NOT NULL, cpu_s REAL NOT NULL, wall_s REAL NOT NULL, work REAL NOT NULL,
    work_unit TEXT NOT NULL, created TEXT NOT NULL, results BLOB NOT NULL);
CREATE INDEX run_key ON run (key, status);
CREATE TABLE measurement (
    run_id INTEGER NOT NULL REFERENCES run (id), observable TEXT NOT NULL, value REAL NOT NULL,
    stderr REAL NOT NULL, systematic REAL NOT NULL, n INTEGER NOT NULL, unit TEXT NOT NULL);
CREATE TABLE entry (
    id INTEGER PRIMARY KEY, created TEXT NOT NULL, command TEXT NOT NULL, version TEXT NOT NULL,
    machine TEXT NOT NULL);
CREATE TABLE verdict (
    entry_id INTEGER NOT NULL REFERENCES entry (id), case_name TEXT NOT NULL, code TEXT NOT NULL,
    observable TEXT NOT NULL, kind TEXT NOT NULL, against TEXT NOT NULL, setting TEXT NOT NULL,
    difference REAL, uncertainty REAL, limit_value REAL, outcome TEXT NOT NULL,
    expected INTEGER NOT NULL, reason TEXT NOT NULL);
INSERT INTO measurement VALUES (1, 'restitution', 0.8, 0.01, 0, 1, '');
INSERT INTO entry VALUES (1, '', 'run', '', '');
INSERT INTO verdict VALUES (1, 'small', '', '', '', '', '', 0, 0, 0, 'agree', 1, '');
PRAGMA user_version = 1;)");
    SQLite::Statement run(file,
                          "INSERT INTO run VALUES (1, 'key', 'small', '', 0, 'lammps', 'v', 0, "
                          "'7', 'ok', '', '', '{}', 1, 1, 1, 'steps', '', ?)");
    const auto blob = nlohmann::json::to_cbor(store::to_json({}));
    run.bind(1, blob.data(), static_cast<int>(blob.size()));
    run.exec();
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_run_comes_back_as_it_was_stored_bit_for_bit) {
    const tests::TemporaryDirectory directory;
    const auto run = stored_run();
    const auto id = Store(directory.path()).add(run);
    const auto found = Store(directory.path()).find("key");  // by another call of the program
    BOOST_TEST_REQUIRE(found.has_value());
    BOOST_TEST(found->id == id);
    BOOST_TEST(found->cached);
    BOOST_TEST(found->key == run.key);
    BOOST_TEST(found->case_name == run.case_name);
    BOOST_TEST(found->variant == run.variant);
    BOOST_TEST(found->rung == run.rung);
    BOOST_TEST(found->code == run.code);
    BOOST_TEST(found->version == run.version);
    BOOST_TEST(found->replica == run.replica);
    BOOST_TEST(found->seed == run.seed);
    BOOST_TEST((found->status == run.status));
    BOOST_TEST(found->settings_json == run.settings_json);
    BOOST_TEST(found->cpu_s == run.cpu_s);
    BOOST_TEST(found->wall_s == run.wall_s);
    BOOST_TEST(found->work == run.work);
    BOOST_TEST(found->work_unit == run.work_unit);
    BOOST_TEST(found->created == run.created);
    BOOST_TEST(tests::same_bits(found->results, run.results));
}

BOOST_AUTO_TEST_CASE(texts_of_any_content_come_back) {
    const tests::TemporaryDirectory directory;
    Store results(directory.path());
    auto run = stored_run("'; DROP TABLE run; --");
    run.version = "Grüße\n\t\"quoted\" 'single' %s";
    run.variant = "";
    (void)results.add(run);
    const auto found = results.find(run.key);
    BOOST_TEST_REQUIRE(found.has_value());
    BOOST_TEST(found->version == run.version);
    BOOST_TEST(found->variant == "");
}

BOOST_AUTO_TEST_CASE(an_unknown_key_is_nothing) {
    const tests::TemporaryDirectory directory;
    Store results(directory.path());
    BOOST_TEST(!results.find("key").has_value());
    (void)results.add(stored_run());
    BOOST_TEST(!results.find("KEY").has_value());
    BOOST_TEST(!results.find("").has_value());
    BOOST_TEST(!results.find("ke_").has_value());
}

BOOST_AUTO_TEST_CASE(the_newest_run_is_found_also_when_it_failed) {
    const tests::TemporaryDirectory directory;
    Store results(directory.path());
    (void)results.add(stored_run("key", 1.0));
    const auto success = results.add(stored_run("key", 2.0));
    (void)results.add(stored_run("another", 3.0));
    BOOST_TEST(results.find("key").value().id == success);
    BOOST_TEST(results.find("key").value().results.measurements.at(0).value == 2.0);
    // An older success must not hide that it does not work any more.
    (void)results.add(failed_run("key"));
    BOOST_TEST((results.find("key").value().status == store::RunStatus::run_failed));
    BOOST_TEST(results.find("key").value().reason == failed_run("key").reason);
}

BOOST_AUTO_TEST_CASE(a_run_that_ran_out_of_time_is_told_from_one_that_failed) {
    const tests::TemporaryDirectory directory;
    Store results(directory.path());
    auto late = failed_run("late");
    late.status = store::RunStatus::timed_out;
    (void)results.add(late);
    BOOST_TEST((results.find("late").value().status == store::RunStatus::timed_out));
    // Documents have one word for both.
    BOOST_TEST(document_word(store::RunStatus::timed_out) == "run_failed");
    BOOST_TEST(has_failed(store::RunStatus::timed_out));
    BOOST_TEST(!has_failed(store::RunStatus::not_run));
}

BOOST_AUTO_TEST_CASE(the_program_behind_a_version_is_known) {
    const tests::TemporaryDirectory directory;
    Store results(directory.path());
    auto run = stored_run();
    run.code = "lammps";
    run.version = "29 Sep 2021";
    BOOST_TEST(!results.last_digest("lammps", "29 Sep 2021").has_value());
    run.digest = "";  // converted from a store that did not know programs
    (void)results.add(run);
    BOOST_TEST(!results.last_digest("lammps", "29 Sep 2021").has_value());
    for (const char* digest : {"abc", "def"}) {
        run.digest = digest;
        run.program = "/usr/bin/lmp";
        (void)results.add(run);
    }
    BOOST_TEST(results.last_digest("lammps", "29 Sep 2021").value() == "def");
    BOOST_TEST(!results.last_digest("lammps", "30 Sep 2021").has_value());
    BOOST_TEST(!results.last_digest("liggghts", "29 Sep 2021").has_value());
    BOOST_TEST(results.find("key").value().program == "/usr/bin/lmp");
    BOOST_TEST(results.find("key").value().digest == "def");
}

BOOST_AUTO_TEST_CASE(a_store_of_format_1_is_converted_with_all_that_is_in_it) {
    const tests::TemporaryDirectory directory;
    write_format_1(directory.path() / "crossgrain.db");
    // Also by a command that only reads.
    const Store results(directory.path(), store::Access::read);
    const auto run = results.find("key");
    BOOST_TEST_REQUIRE(run.has_value());
    BOOST_TEST(run->case_name == "small");
    BOOST_TEST(run->seed == 7u);
    BOOST_TEST(run->digest.empty());
    BOOST_TEST(results.history().size() == 2u);
    const SQLite::Database file((directory.path() / "crossgrain.db").string());
    BOOST_TEST(const_cast<SQLite::Database&>(file)
                   .execAndGet("SELECT group_concat(name, ' ') FROM (SELECT name FROM "
                               "sqlite_master WHERE type = 'table' ORDER BY name)")
                   .getString() == "entry measurement result run verdict");
}

BOOST_AUTO_TEST_CASE(history_holds_every_value_and_cost_of_every_success_oldest_first) {
    const tests::TemporaryDirectory directory;
    Store results(directory.path());
    BOOST_TEST(results.history().empty());
    const auto first = results.add(stored_run("a", 1.0));
    (void)results.add(failed_run("b"));
    const auto second = results.add(stored_run("a", 2.0));
    const auto points = results.history();
    BOOST_TEST_REQUIRE(points.size() == 6u);  // two values and a cost, twice
    for (std::size_t i = 0; i < points.size(); ++i) {
        BOOST_TEST(points[i].run_id == (i < 3 ? first : second));
        BOOST_TEST(points[i].case_name == "small");
        BOOST_TEST(points[i].variant == "clip-all");
        BOOST_TEST(points[i].code == "native-dem");
        BOOST_TEST(points[i].version == "0.1.0 (engine 1a2b3c4d)");
        BOOST_TEST(points[i].created == "2026-01-31T12:00:00Z");
        BOOST_TEST(points[i].settings_json == R"({"dt":0.001,"N":16})");
        BOOST_TEST(points[i].seed == 18446744073709551615U);
        if (points[i].observable == "cpu_s") {
            BOOST_TEST(points[i].unit == "s");
            BOOST_TEST(points[i].value == 1.25);
            BOOST_TEST(points[i].standard_error == 0.0);
        } else if (points[i].observable == "restitution") {
            BOOST_TEST(points[i].unit == "l/t");
            BOOST_TEST(points[i].value == (i < 3 ? 1.0 : 2.0));
            BOOST_TEST(points[i].standard_error == 5e-324);
        } else {
            BOOST_TEST(points[i].observable == "no scatter");
        }
    }
}

BOOST_AUTO_TEST_CASE(two_stores_on_one_file_see_each_other) {
    const tests::TemporaryDirectory directory;
    Store one(directory.path()), other(directory.path());
    (void)one.add(stored_run("a"));
    (void)other.add(stored_run("b"));
    BOOST_TEST(one.find("b").has_value());
    BOOST_TEST(other.find("a").has_value());
    BOOST_TEST(one.history().size() == other.history().size());
}

BOOST_AUTO_TEST_CASE(stores_that_write_at_the_same_time_wait_for_each_other) {
    const tests::TemporaryDirectory directory;
    constexpr int runs = 20;
    const auto write = [&](const std::string& name, bool& ok) {
        try {
            Store results(directory.path());
            for (int i = 0; i < runs; ++i)
                (void)results.add(stored_run(name + std::to_string(i)));
            ok = true;
        } catch (const store::StoreError&) {
        }
    };
    bool first = false, second = false;
    std::thread a(write, "a", std::ref(first)), b(write, "b", std::ref(second));
    a.join();
    b.join();
    BOOST_TEST(first);
    BOOST_TEST(second);
    BOOST_TEST(Store(directory.path()).history().size() == 2u * runs * 3u);
}

BOOST_AUTO_TEST_CASE(verdicts_are_stored_with_their_entry) {
    const tests::TemporaryDirectory directory;
    Store results(directory.path());
    const auto entry =
        results.begin_entry({.command = "validate", .version = "0.1.0", .machine = "two cores"});
    BOOST_TEST(entry.id > 0);
    BOOST_TEST(entry.created.size() == 20u);
    BOOST_TEST(results.begin_entry({.command = "run"}).id == entry.id + 1);
    results.add_verdicts(entry, "small",
                         {{.code = "lammps",
                           .observable = "restitution",
                           .kind = "parity",
                           .against = "native-dem",
                           .setting = "clip-all",
                           .difference = -1e-17,
                           .uncertainty = 5e-324,
                           .limit = 1e-12,
                           .outcome = "disagree",
                           .expected = false,
                           .reason = "they differ"},
                          {.code = "yade", .difference = std::nan("")}});
    const SQLite::Database file((directory.path() / "crossgrain.db").string());
    SQLite::Statement query(file, "SELECT * FROM verdict ORDER BY rowid");
    BOOST_TEST_REQUIRE(query.executeStep());
    BOOST_TEST(query.getColumn("entry_id").getInt64() == entry.id);
    BOOST_TEST(query.getColumn("case_name").getString() == "small");
    BOOST_TEST(query.getColumn("code").getString() == "lammps");
    BOOST_TEST(query.getColumn("kind").getString() == "parity");
    BOOST_TEST(query.getColumn("against").getString() == "native-dem");
    BOOST_TEST(query.getColumn("difference").getDouble() == -1e-17);
    BOOST_TEST(query.getColumn("uncertainty").getDouble() == 5e-324);
    BOOST_TEST(query.getColumn("limit_value").getDouble() == 1e-12);
    BOOST_TEST(query.getColumn("outcome").getString() == "disagree");
    BOOST_TEST(query.getColumn("expected").getInt() == 0);
    BOOST_TEST(query.getColumn("reason").getString() == "they differ");
    BOOST_TEST_REQUIRE(query.executeStep());  // a difference that is no number is none
    BOOST_TEST(query.getColumn("difference").isNull());
    BOOST_TEST(query.getColumn("expected").getInt() == 1);
    BOOST_TEST(!query.executeStep());
}

BOOST_AUTO_TEST_CASE(now_is_written_as_iso_8601_in_utc) {
    const std::string now = store::utc_now();
    BOOST_TEST_REQUIRE(now.size() == 20u);
    BOOST_TEST(now[4] == '-');
    BOOST_TEST(now[10] == 'T');
    BOOST_TEST(now[19] == 'Z');
    BOOST_TEST(now > "2024-01-01T00:00:00Z");
}
