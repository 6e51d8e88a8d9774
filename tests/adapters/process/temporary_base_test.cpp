// The place of temporary directories must be ours alone, and what is wrong with it is said.
#include "adapters/process/temporary_base.hpp"
#include "native/base/errors.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <cstdlib>
#include <filesystem>
#include <string>

#include <unistd.h>

namespace fs = std::filesystem;
using crossgrain::CaseError;
using crossgrain::adapters::process::temporary_base;

namespace {

/// TMPDIR for the time of a test.
class OtherTemporary {
  public:
    explicit OtherTemporary(const fs::path& path) {
        if (const char* value = std::getenv("TMPDIR")) before_ = value;
        setenv("TMPDIR", path.c_str(), 1);
    }
    ~OtherTemporary() {
        before_.empty() ? unsetenv("TMPDIR") : setenv("TMPDIR", before_.c_str(), 1);
    }
    OtherTemporary(const OtherTemporary&) = delete;
    OtherTemporary& operator=(const OtherTemporary&) = delete;

  private:
    std::string before_;
};

std::string problem_of() {
    try {
        (void)temporary_base();
    } catch (const CaseError& error) {
        BOOST_TEST(error.details().hint.find("TMPDIR") != std::string::npos);
        return error.details().problem;
    }
    return "none";
}

}  // namespace

BOOST_AUTO_TEST_CASE(made_once_for_this_user_alone) {
    const crossgrain::tests::TemporaryDirectory directory;
    const OtherTemporary other(directory.path());
    const auto base = temporary_base();
    BOOST_TEST(base == directory.path() / ("crossgrain-" + std::to_string(geteuid())));
    BOOST_TEST((fs::status(base).permissions() == fs::perms::owner_all));
    BOOST_TEST(temporary_base() == base);
}

BOOST_AUTO_TEST_CASE(somebody_else_may_have_made_it) {
    const crossgrain::tests::TemporaryDirectory directory;
    const OtherTemporary other(directory.path());
    const auto base = temporary_base();
    const std::string refusal = "is not a directory of this user alone (mode 0700)";
    fs::permissions(base, fs::perms::group_read, fs::perm_options::add);
    BOOST_TEST(problem_of() == refusal);
    fs::rename(base, directory.path() / "elsewhere");
    fs::permissions(directory.path() / "elsewhere", fs::perms::owner_all);
    fs::create_directory_symlink(directory.path() / "elsewhere", base);
    BOOST_TEST(problem_of() == refusal);
    fs::remove(base);
    BOOST_TEST(problem_of() == "none");
    if (geteuid() == 0) {
        BOOST_TEST_REQUIRE(chown(base.c_str(), 1, 1) == 0);
        BOOST_TEST(problem_of() == refusal);
    }
}

BOOST_AUTO_TEST_CASE(no_place_at_all) {
    const OtherTemporary missing("/no/such/directory");
    BOOST_TEST(problem_of() == "is not a directory");
    // Where nobody can make a directory.
    const OtherTemporary impossible("/proc");
    BOOST_TEST(problem_of().starts_with("cannot be made: "));
}
