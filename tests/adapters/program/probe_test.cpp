// What programs answer when they are asked what they are, and what becomes of it: each stands in
// for a broken or a changed LAMMPS, LIGGGHTS or YADE.
#include "adapters/lammps/lammps_code.hpp"
#include "adapters/liggghts/liggghts_code.hpp"
#include "adapters/yade/module_files.hpp"
#include "adapters/yade/yade_code.hpp"
#include "native/base/errors.hpp"
#include "native/base/printable.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <stop_token>
#include <string>
#include <thread>

using namespace crossgrain;
using adapters::Availability;
using adapters::LammpsCode;
using adapters::LiggghtsCode;
using adapters::YadeCode;

namespace {

/// A program that runs this shell script.
class Program {
  public:
    explicit Program(const std::string& script) {
        std::ofstream(path()) << "#!/bin/sh\n" << script << '\n';
        std::filesystem::permissions(path(), std::filesystem::perms::owner_all);
    }
    [[nodiscard]] std::string path() const { return (directory_.path() / "program").string(); }

  private:
    tests::TemporaryDirectory directory_;
};

template <class Code>
Availability probe(const std::string& script) {
    const Program program(script);
    return Code(program.path()).probe();
}

/// Why it is of no use, without the path of the program.
template <class Code>
std::string reason(const std::string& script) {
    const Program program(script);
    const auto found = Code(program.path()).probe();
    BOOST_TEST(!found.installed);
    BOOST_TEST(found.version.empty());
    std::string text = found.reason;
    for (auto at = text.find(program.path()); at != std::string::npos;
         at = text.find(program.path()))
        text.replace(at, program.path().size(), "P");
    return text;
}

const std::string lammps_head = "echo 'Large-scale Atomic/Molecular Massively Parallel Simulator "
                                "- 29 Sep 2021 - Update 2'\n";
const std::string liggghts_head = "echo 'LIGGGHTS (Version LIGGGHTS-PUBLIC 3.8.0, compiled now)'\n";

}  // namespace

BOOST_AUTO_TEST_CASE(good_answers) {
    const auto lammps = probe<LammpsCode>(lammps_head + "echo granular");
    BOOST_TEST(lammps.installed);
    BOOST_TEST(lammps.version == "29 Sep 2021 - Update 2");
    BOOST_TEST(lammps.digest.size() == 64);
    BOOST_TEST(lammps.program.ends_with("/program"));
    // LIGGGHTS exits with 1 from its own help.
    const auto liggghts = probe<LiggghtsCode>(liggghts_head + "exit 1");
    BOOST_TEST(liggghts.installed);
    BOOST_TEST(liggghts.version == "3.8.0");
    BOOST_TEST(probe<YadeCode>("echo 'Yade version: 2023.02a '").version == "2023.02a");
}

BOOST_AUTO_TEST_CASE(a_program_that_crashes_is_not_installed) {
    BOOST_TEST(reason<LiggghtsCode>("kill -SEGV $$") == "'P -h -log none' was killed by signal 11");
    // Even if it has named its version before.
    BOOST_TEST(reason<LammpsCode>(lammps_head + "echo granular; kill -ABRT $$") ==
               "'P -h' was killed by signal 6");
}

BOOST_AUTO_TEST_CASE(a_missing_library_is_not_a_missing_pair_style) {
    const std::string words = "error while loading shared libraries: libfoo.so: cannot open shared "
                              "object file: No such file or directory";
    BOOST_TEST(reason<LammpsCode>("echo 'lmp: " + words + "' >&2; exit 127") ==
               "'P -h' does not run: lmp: " + words);
    // As it is said through a wrapper that has its own exit status.
    BOOST_TEST(reason<LammpsCode>("echo 'lmp: " + words + "' >&2; exit 1") ==
               "'P -h' does not run: lmp: " + words);
    BOOST_TEST(reason<LammpsCode>("echo \"lmp: version 'GLIBC_9' not found\" >&2; exit 1") ==
               "'P -h' does not name a version of LAMMPS (exit status 1: 'lmp: version 'GLIBC_9' "
               "not found')");
    BOOST_TEST(reason<YadeCode>("crossgrain-no-such-python").find("does not run: ") !=
               std::string::npos);
}

BOOST_AUTO_TEST_CASE(an_answer_without_a_version_is_none) {
    BOOST_TEST(reason<LammpsCode>("echo granular")
                   .starts_with("'P -h' does not name a version of LAMMPS"));
    BOOST_TEST(reason<LiggghtsCode>("echo '(Version 7)'")
                   .starts_with("'P -h' does not name a version of LIGGGHTS"));
    BOOST_TEST(reason<LiggghtsCode>("echo 'LIGGGHTS (Version '")
                   .starts_with("'P -h' does not name a version of LIGGGHTS"));
    BOOST_TEST(reason<YadeCode>("echo 'Yade version: '").find("does not name a version") !=
               std::string::npos);
    BOOST_TEST(reason<LammpsCode>(lammps_head) == "'P' is built without pair style granular");
}

BOOST_AUTO_TEST_CASE(bytes_of_an_answer_are_escaped_and_bounded) {
    const auto version = probe<YadeCode>("printf 'Yade version: 1\\033[31m\\377\\n'").version;
    BOOST_TEST(version == "1\\x1b[31m\\xff");
    const auto words = reason<LammpsCode>("printf '\\033]0;title\\007\\377' >&2; exit 1");
    BOOST_TEST(is_printable(words));
    BOOST_TEST(words.find("\\x1b]0;title\\x07\\xff") != std::string::npos);
    BOOST_TEST(probe<YadeCode>("printf 'Yade version: '; head -c 100000 /dev/zero | tr '\\0' 9")
                   .version.size() < 300);
    BOOST_TEST(reason<LammpsCode>("exec yes") == "'P -h' was ended because it wrote more than 1 "
                                                 "MiB to its standard output or a file");
}

BOOST_AUTO_TEST_CASE(a_changed_wrapper_is_another_program_of_the_same_version) {
    const auto ask = [](const std::string& parameter) {
        return probe<LammpsCode>("gamma=" + parameter + "\n" + lammps_head + "echo granular");
    };
    const auto healthy = ask("0.10"), patched = ask("0.11");
    BOOST_TEST(healthy.version == patched.version);
    BOOST_TEST(healthy.digest != patched.digest);
    BOOST_TEST(healthy.digest == ask("0.10").digest);
}

BOOST_AUTO_TEST_CASE(a_stop_request_ends_the_question) {
    const Program slow("sleep 60");
    const LammpsCode code(slow.path());
    std::stop_source source;
    std::jthread stopper([&source] {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        source.request_stop();
    });
    const auto start = std::chrono::steady_clock::now();
    BOOST_CHECK_THROW((void)code.probe(source.get_token()), Interrupted);
    BOOST_TEST((std::chrono::steady_clock::now() - start < std::chrono::seconds(10)));
}

BOOST_AUTO_TEST_CASE(modules_of_yade) {
    const tests::TemporaryDirectory directory;
    const auto modules = directory.path() / "yade/py";
    std::filesystem::create_directories(modules / "yade");
    std::ofstream(modules / "yade/utils.py") << "x = 1\n";
    std::ofstream(modules / "yade/data.txt") << "x\n";
    std::ofstream(modules.parent_path() / "libyade.so") << "ELF\n";
    const auto script = directory.path() / "script";
    std::ofstream(script) << "import sys\n\nsys.path.insert(1,'" << modules.string() << "')\n";
    BOOST_TEST(adapters::yade::module_files(script).size() == 2);
    std::ofstream(script) << "exec yade \"$@\"\n";
    BOOST_TEST(adapters::yade::module_files(script).empty());
    std::ofstream(script) << "sys.path.insert(1,'/no/such/py')\nsys.path.insert(1,'/')\n"
                             "sys.path.insert(1,'";
    BOOST_TEST(adapters::yade::module_files(script).empty());
}
