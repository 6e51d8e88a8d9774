// An error is one line that holds all that is known about where and what, and nothing else.
#include "native/base/errors.hpp"

#include <boost/test/unit_test.hpp>

#include <stdexcept>
#include <string>

using namespace crossgrain;

namespace {

const CaseErrorDetails complete{.file = "cases/x.toml",
                                .line = 12,
                                .column = 7,
                                .key = "scene.contact.restitution",
                                .problem = "is out of range",
                                .got = "1.2",
                                .expected = "a number in (0, 1]",
                                .hint = "did you mean 0.12?"};

std::string line_of(const CaseErrorDetails& details) {
    return CaseError(details).what();
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_case_error_says_where_what_and_what_would_be_right) {
    BOOST_TEST(line_of(complete) ==
               "cases/x.toml:12:7: 'scene.contact.restitution' is out of range: got 1.2, "
               "expected a number in (0, 1]; did you mean 0.12?");
}

BOOST_AUTO_TEST_CASE(a_case_error_leaves_out_what_is_unknown) {
    auto details = complete;
    details.column = 0;
    BOOST_TEST(line_of(details).starts_with("cases/x.toml:12: 'scene."));
    details.line = 0;
    BOOST_TEST(line_of(details).starts_with("cases/x.toml: 'scene."));
    details.column = 7;  // a column without a line places nothing
    BOOST_TEST(line_of(details).starts_with("cases/x.toml: 'scene."));
    details.file.clear();
    BOOST_TEST(line_of(details).starts_with("'scene.contact.restitution' is out"));
    details.key.clear();
    details.hint.clear();
    BOOST_TEST(line_of(details) == "is out of range: got 1.2, expected a number in (0, 1]");
    BOOST_TEST(line_of({.file = "a", .problem = "cannot be read"}) == "a: cannot be read");
}

BOOST_AUTO_TEST_CASE(a_case_error_keeps_its_parts_for_programs) {
    const CaseError error(complete);
    BOOST_TEST(error.details().file == complete.file);
    BOOST_TEST(error.details().line == 12);
    BOOST_TEST(error.details().column == 7);
    BOOST_TEST(error.details().key == complete.key);
    BOOST_TEST(error.details().problem == complete.problem);
    BOOST_TEST(error.details().got == complete.got);
    BOOST_TEST(error.details().expected == complete.expected);
    BOOST_TEST(error.details().hint == complete.hint);
}

BOOST_AUTO_TEST_CASE(an_adapter_error_is_one_line_whatever_the_log_holds) {
    const AdapterError error({.code = "lammps",
                              .reason = "dump ends in the middle of frame 2000",
                              .command = "lmp -in in.txt",
                              .exit = "exit status 1",
                              .log_tail = "ERROR: lost atoms\nLast command: run 100",
                              .directory = "runs/7"});
    const std::string line = error.what();
    BOOST_TEST(line == "lammps: dump ends in the middle of frame 2000 (exit status 1); inputs and "
                       "logs in runs/7");
    BOOST_TEST(error.details().log_tail == "ERROR: lost atoms\nLast command: run 100");
    BOOST_TEST(error.details().command == "lmp -in in.txt");
    const AdapterError native({.code = "native-dem", .reason = "no frame"});
    BOOST_TEST(std::string(native.what()) == "native-dem: no frame");
}

BOOST_AUTO_TEST_CASE(kinds_of_errors_stay_apart) {
    // The exit code of the program depends on the kind: none may be caught as another.
    BOOST_CHECK_THROW(throw TrajectoryError("x"), TrajectoryError);
    const auto is_trajectory_error = [](const std::runtime_error& error) {
        return dynamic_cast<const TrajectoryError*>(&error) != nullptr;
    };
    BOOST_TEST(!is_trajectory_error(CaseError(complete)));
    BOOST_TEST(!is_trajectory_error(AdapterError({.code = "a", .reason = "b"})));
    BOOST_TEST(!is_trajectory_error(Interrupted()));
    BOOST_TEST(std::string(Interrupted().what()) == "interrupted");
}
