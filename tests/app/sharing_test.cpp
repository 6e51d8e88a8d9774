// No run is taken for another: whoever shares a results directory, a name or a program's version,
// each run is computed once, in a directory of its own, and found again only as what it was.
#include "tests/app/program.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <functional>
#include <future>
#include <set>
#include <string>
#include <utility>
#include <vector>

using crossgrain::tests::Answer;
using crossgrain::tests::Program;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// (key, observable, value) of everything in a store, sorted; and that no key is there twice.
std::vector<std::string> stored(const Program& crossgrain) {
    SQLite::Database file((crossgrain.results() / "crossgrain.db").string());
    const int twice = file.execAndGet("SELECT count(*) - count(DISTINCT key) FROM run").getInt();
    BOOST_TEST(twice == 0);
    SQLite::Statement query(file, "SELECT key || ' ' || observable || ' ' || hex(value) FROM run "
                                  "JOIN measurement ON run_id = id WHERE status = 'ok'");
    std::vector<std::string> rows;
    while (query.executeStep())
        rows.push_back(query.getColumn(0).getString());
    std::ranges::sort(rows);
    return rows;
}

/// Calls of the program at the same time, on the results of `first`.
std::vector<Answer> side_by_side(const Program& first,
                                 const std::vector<std::vector<std::string>>& calls) {
    std::vector<std::future<Answer>> pending;
    for (const auto& arguments : calls) {
        pending.push_back(std::async(std::launch::async, [&first, arguments] {
            Program crossgrain;
            crossgrain.shared_results = first.results();
            return crossgrain(arguments);
        }));
    }
    std::vector<Answer> answers;
    for (auto& answer : pending)
        answers.push_back(answer.get());
    return answers;
}

std::vector<std::string> run_of(const std::string& file, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{"run", file, "--code", "native-dem", "--replicas", "6"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

/// The case "small-gas" with variants in which only restitution differs, by their names.
std::string with_variants(const Program& crossgrain,
                          const std::vector<std::pair<std::string, double>>& variants) {
    std::string text = "[[observable]]\nname = \"momentum\"\n";
    for (const auto& [name, restitution] : variants) {
        text += "\n[[variant]]\nname = \"" + name +
                "\"\nscene = { contact = { restitution = " + std::to_string(restitution) + " } }\n";
    }
    return crossgrain.case_with("small-gas", "[[observable]]\nname = \"momentum\"\n", text);
}

void check_all_ok(const std::vector<Answer>& answers) {
    for (const auto& answer : answers)
        BOOST_TEST(answer.status == 0, answer.err);
}

void check_no_directory_is_left(const Program& crossgrain) {
    const fs::path runs = crossgrain.results() / "runs";
    if (fs::exists(runs)) BOOST_TEST(fs::is_empty(runs));
}

}  // namespace

BOOST_AUTO_TEST_CASE(processes_with_the_same_case_compute_each_run_once) {
    const Program serial;
    const auto file = serial.case_with("small-gas", "name = ", "name = ");
    BOOST_TEST(serial(run_of(file, {"--jobs", "1"})).status == 0);
    for (const std::size_t processes : {2u, 10u}) {
        const Program shared;
        check_all_ok(side_by_side(shared, {processes, run_of(file)}));
        BOOST_TEST(stored(shared) == stored(serial), boost::test_tools::per_element());
        check_no_directory_is_left(shared);
    }
}

BOOST_AUTO_TEST_CASE(processes_with_different_cases_do_not_disturb_each_other) {
    std::vector<Program> writers(5);
    std::vector<std::vector<std::string>> calls;
    for (std::size_t i = 0; i < writers.size(); ++i) {
        const std::string restitution = "restitution = 0." + std::to_string(5 + i);
        // All of the same name: names identify nothing.
        calls.push_back(
            run_of(writers[i].case_with("small-gas", "restitution = 0.8", restitution)));
        calls.push_back(calls.back());
    }
    const Program serial, shared;
    for (const auto& call : calls)
        BOOST_TEST(serial(call).status == 0);
    check_all_ok(side_by_side(shared, calls));
    BOOST_TEST(stored(shared) == stored(serial), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(two_cases_of_one_name_are_refused_and_one_file_counts_once) {
    const Program one, other;
    const auto a = one.case_with("small-gas", "restitution = 0.8", "restitution = 0.7");
    const auto b = other.case_with("small-gas", "restitution = 0.8", "restitution = 0.6");
    const Answer refused = one({"run", a, b, "--code", "native-dem"});
    BOOST_TEST(refused.status == 2);
    BOOST_TEST(refused.error_lines() == 1);
    BOOST_TEST(refused.says(a));
    BOOST_TEST(refused.says(b));
    const Answer twice = one({"run", a, a, "--code", "native-dem"});
    BOOST_TEST(twice.status == 0);
    BOOST_TEST(twice.says("1 runs computed"));
}

BOOST_AUTO_TEST_CASE(variants_that_look_alike_keep_their_own_dumps) {
    const Program crossgrain;
    const auto file = with_variants(crossgrain, {{"a b", 0.9}, {"a-b", 0.7}, {"a#b", 0.5}});
    const Answer answer =
        crossgrain({"run", file, "--code", "native-dem", "--keep-dumps", "--json", "--jobs", "3"});
    BOOST_TEST(answer.status == 0, answer.err);
    std::set<std::size_t> dumps;
    for (const auto& run : fs::directory_iterator(crossgrain.results() / "runs")) {
        BOOST_TEST(fs::exists(run.path() / "dump.txt.zst"), run.path().string());
        std::ifstream in(run.path() / "dump.txt.zst");
        dumps.insert(std::hash<std::string>()({std::istreambuf_iterator<char>(in), {}}));
    }
    BOOST_TEST(dumps.size() == 3u);
}

BOOST_AUTO_TEST_CASE(variants_that_are_the_same_are_computed_once) {
    const Program crossgrain;
    const auto file = with_variants(crossgrain, {{"one", 0.9}, {"same", 0.9}, {"other", 0.7}});
    const Answer answer = crossgrain({"run", file, "--code", "native-dem", "--json"});
    BOOST_TEST(answer.says("2 runs computed"));
    (void)stored(crossgrain);
    std::size_t runs = 0;
    const json document = json::parse(answer.out);
    for (const auto& run : document["cases"][0]["runs"])
        runs += run["status"] == "ok" ? 1 : 0;
    BOOST_TEST(runs == 3u);
}

BOOST_AUTO_TEST_CASE(a_failure_is_not_hidden_by_an_older_success) {
    const Program crossgrain;
    const auto file = crossgrain.case_with("small-bed", "name = ", "name = ");
    const std::vector<std::string> compare{"compare",    file,      "--code",
                                           "native-dem", "--suite", "full"};
    BOOST_TEST(crossgrain({"run", file, "--code", "native-dem"}).status == 0);
    BOOST_TEST(crossgrain(compare).status == 0);
    const Answer failed =
        crossgrain({"run", file, "--code", "native-dem", "--fresh", "--time-limit", "1e-9"});
    BOOST_TEST(failed.status == 3);
    const Answer seen = crossgrain(compare);
    BOOST_TEST(seen.status == 3);
    BOOST_TEST(seen.says("time limit"));
    // It is tried again, and found then.
    BOOST_TEST(crossgrain({"run", file, "--code", "native-dem"}).says("1 runs computed"));
    BOOST_TEST(crossgrain(compare).status == 0);
}

BOOST_AUTO_TEST_CASE(the_directory_of_a_failed_run_can_be_looked_at_and_does_not_pile_up) {
    const Program crossgrain;
    const auto file = crossgrain.case_with("small-bed", "name = ", "name = ");
    for (int attempt = 0; attempt < 3; ++attempt) {
        const Answer failed =
            crossgrain({"run", file, "--code", "native-dem", "--time-limit", "1e-9"});
        BOOST_TEST(failed.status == 3);
        std::vector<fs::path> kept;
        for (const auto& run : fs::directory_iterator(crossgrain.results() / "runs"))
            kept.push_back(run.path());
        BOOST_TEST_REQUIRE(kept.size() == 1u);
        BOOST_TEST(failed.says(kept.front().string()));
    }
}

BOOST_AUTO_TEST_CASE(results_that_are_not_there_are_not_made_by_those_who_read) {
    for (const char* command : {"compare", "report", "history", "regressions"}) {
        const Program crossgrain;
        const Answer answer = crossgrain({command});
        BOOST_TEST(answer.status == 2, command);
        BOOST_TEST(answer.error_lines() == 1);
        BOOST_TEST(answer.says("does not exist"));
        BOOST_TEST(!fs::exists(crossgrain.results()));
    }
}

BOOST_AUTO_TEST_CASE(a_call_that_is_refused_leaves_the_results_as_they_were) {
    for (const char* command : {"run", "certify", "chart", "validate", "stability"}) {
        const Program crossgrain;
        fs::create_directories(crossgrain.results());
        BOOST_TEST(crossgrain({command, "no-such-case"}).status == 2);
        BOOST_TEST(fs::is_empty(crossgrain.results()), command);
    }
}

BOOST_AUTO_TEST_CASE(a_damaged_row_is_computed_again) {
    const Program crossgrain;
    const auto file = crossgrain.case_with("small-gas", "name = ", "name = ");
    const std::vector<std::string> command{"run", file, "--code", "native-dem"};
    BOOST_TEST(crossgrain(command).status == 0);
    {
        SQLite::Database store((crossgrain.results() / "crossgrain.db").string(),
                               SQLite::OPEN_READWRITE);
        store.exec("UPDATE result SET results = x'8181'");
    }
    const Answer again = crossgrain(command);
    BOOST_TEST(again.status == 0);
    BOOST_TEST(again.says("is damaged and not used"));
    BOOST_TEST(again.says("1 runs computed"));
    {
        SQLite::Database store((crossgrain.results() / "crossgrain.db").string(),
                               SQLite::OPEN_READWRITE);
        store.exec("UPDATE run SET code = 'another'");
    }
    BOOST_TEST(crossgrain(command).says("claims to be one of another and is not used"));
    BOOST_TEST(crossgrain(command).says("0 runs computed"));
}
