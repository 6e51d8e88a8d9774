// A run is computed by one at a time, among threads and among processes, whatever happens to them.
#include "adapters/run/store/run_claim.hpp"

#include "adapters/run/store/access.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <csignal>
#include <stdexcept>
#include <string>

#include <sys/wait.h>
#include <unistd.h>

using crossgrain::store::RunClaim;
using crossgrain::tests::TemporaryDirectory;

namespace {

const std::string key(64, 'a'), other_key = std::string(14, 'a') + std::string(50, 'b');

}  // namespace

BOOST_AUTO_TEST_CASE(a_key_is_claimed_once_and_free_again_afterwards) {
    const TemporaryDirectory directory;
    {
        const auto mine = RunClaim::take(directory.path(), key);
        BOOST_TEST(mine.has_value());
        BOOST_TEST(!RunClaim::take(directory.path(), key).has_value());
        BOOST_TEST(RunClaim::take(directory.path(), other_key).has_value());
        const TemporaryDirectory elsewhere;
        BOOST_TEST(RunClaim::take(elsewhere.path(), key).has_value());
    }
    BOOST_TEST(RunClaim::take(directory.path(), key).has_value());
}

BOOST_AUTO_TEST_CASE(a_claim_ends_with_its_process) {
    const TemporaryDirectory directory;
    int ready[2];
    BOOST_TEST_REQUIRE(pipe(ready) == 0);
    const pid_t child = fork();
    if (child == 0) {
        const auto held = RunClaim::take(directory.path(), key);
        (void)!write(ready[1], held ? "1" : "0", 1);
        pause();
        _exit(0);
    }
    char held = '0';
    BOOST_TEST(read(ready[0], &held, 1) == 1);
    BOOST_TEST(held == '1');
    BOOST_TEST(!RunClaim::take(directory.path(), key).has_value());
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    BOOST_TEST(RunClaim::take(directory.path(), key).has_value());
    close(ready[0]);
    close(ready[1]);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_locked_is_refused) {
    const TemporaryDirectory directory;
    BOOST_CHECK_THROW((void)RunClaim::take(directory.path() / "missing", key),
                      crossgrain::store::StoreError);
    BOOST_CHECK_THROW((void)RunClaim::take(directory.path(), "short"), std::invalid_argument);
    BOOST_CHECK_THROW((void)RunClaim::take(directory.path(), std::string(64, 'x')),
                      std::invalid_argument);
}
