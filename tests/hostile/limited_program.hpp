// The program as a careless user runs it on a hostile input: with little memory and not for ever.
#pragma once

#include "native/base/printable.hpp"
#include "tests/app/program.hpp"

#include <boost/test/unit_test.hpp>

#include <sstream>
#include <string>
#include <vector>

namespace crossgrain::tests {

/// A minute and 2 GiB of address space; sanitizers reserve more by themselves.
class LimitedProgram : public Program {
  public:
    LimitedProgram() {
        launcher = {"timeout", "60"};
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
        launcher.insert(launcher.end(), {"sh", "-c", "ulimit -v 2097152; exec \"$@\"", "sh"});
#endif
    }
};

/// Exit code 2 and one error line that has all of the words and could be shown anywhere.
inline void check_refused(const Answer& answer, const std::vector<std::string>& words) {
    BOOST_TEST(answer.status == 2);
    std::istringstream lines(answer.err);
    int errors = 0;
    for (std::string line; std::getline(lines, line);) {
        errors += line.starts_with("error:") ? 1 : 0;
        BOOST_TEST(is_printable(line));
        BOOST_TEST(line.size() < 1500u);
    }
    BOOST_TEST(errors == 1, printable(answer.err, 1000));
    for (const auto& word : words)
        BOOST_TEST(answer.err.find(word) != std::string::npos,
                   "missing: " << word << " in " << printable(answer.err, 1000));
}

}  // namespace crossgrain::tests
