// Protects tools/same-answers.sh, by which a change is judged that must not change a number: it
// accepts what is the same, and finds every kind of difference.
#include "tests/app/program.hpp"

#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <ostream>

using crossgrain::tests::Answer;
using crossgrain::tests::Program;

namespace {

/// What the tool says to a second store that is a copy of the first, changed by `sql`.
Answer compared(const Program& crossgrain, const std::string& sql) {
    const auto file = crossgrain.case_with("small-gas", "name = ", "name = ");
    BOOST_REQUIRE(crossgrain({"run", file, "--code", "native-dem", "--quiet"}).status == 0);
    return crossgrain.shell(
        "rm -rf changed && cp -r \"$RESULTS\" changed && sqlite3 changed/crossgrain.db \"" + sql +
        "\" && " CROSSGRAIN_SOURCE_DIR "/tools/same-answers.sh \"$RESULTS\" changed");
}

struct Change {
    const char* sql;
    const char* found;
    friend std::ostream& operator<<(std::ostream& out, const Change& c) { return out << c.sql; }
};
const Change changes[] = {
    {"UPDATE measurement SET value = value + 1e-16 + abs(value)*1e-15 WHERE rowid = 1",
     "measurement  "},
    {"UPDATE measurement SET stderr = stderr + 1e-9 WHERE rowid = 1", "measurement  "},
    {"DELETE FROM measurement WHERE rowid = 1", "measurement in the old store only"},
    {"INSERT INTO measurement SELECT run_id, 'new', value, stderr, systematic, n, unit FROM "
     "measurement LIMIT 1",
     "measurement in the new store only"},
    {"UPDATE run SET status = 'run_failed'", "status"},
    {"DELETE FROM run", "run in the old store only"},
    {"UPDATE run SET seed = '77'", "run in the new store only"},
    {"UPDATE result SET results = x'f6'", "series, settings, snapshots or pictures"},
    {"UPDATE verdict SET outcome = 'undecided' WHERE rowid = 1", "verdict in the new store only"},
    {"UPDATE verdict SET difference = difference + 1e-15 WHERE rowid = 1",
     "verdict in the old store only"},
    {"DELETE FROM verdict WHERE rowid = 1", "verdict in the old store only"},
    {"INSERT INTO verdict SELECT * FROM verdict", "verdict in the new store only"},
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_copy_gives_the_same_answers) {
    const Program crossgrain;
    const Answer answer = compared(crossgrain, "SELECT 1");
    BOOST_TEST(answer.status == 0, answer.out + answer.err);
    BOOST_TEST(answer.says("same-answers: 1 runs, "));
    BOOST_TEST(answer.says(": 0 differences"));
}

BOOST_DATA_TEST_CASE(every_kind_of_difference_is_found, boost::unit_test::data::make(changes)) {
    const Program crossgrain;
    const Answer answer = compared(crossgrain, sample.sql);
    BOOST_TEST(answer.status == 1, answer.out + answer.err);
    BOOST_TEST(answer.says(sample.found), answer.out + answer.err);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_compared_is_not_the_same) {
    const Program crossgrain;
    BOOST_TEST(compared(crossgrain, "PRAGMA user_version = 1").status == 2);
    const Answer nothing = crossgrain.shell(CROSSGRAIN_SOURCE_DIR "/tools/same-answers.sh . .");
    BOOST_TEST(nothing.status == 2);
    BOOST_TEST(nothing.says("no store"));
    // Two stores without a run have no answers.
    const Answer empty = compared(crossgrain, "DELETE FROM run; DELETE FROM verdict");
    BOOST_TEST(empty.status == 1);
}
