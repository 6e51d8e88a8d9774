// Dumps that are none: each is refused in one truthful line, with exit code 2, whatever bytes it
// holds; dumps that are only unusual are read.
#include "tests/hostile/limited_program.hpp"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <nlohmann/json.hpp>

#include <csignal>
#include <ostream>
#include <thread>

#include <sys/stat.h>

using namespace crossgrain::tests;
namespace data = boost::unit_test::data;
namespace fs = std::filesystem;

namespace {

const std::string inputs = CROSSGRAIN_SOURCE_DIR "/tests/hostile/";

struct Dump {
    std::string file;
    std::string words;  ///< of the refusal
};

std::ostream& operator<<(std::ostream& out, const Dump& dump) {
    return out << dump.file;
}

const std::vector<Dump> refused{
    {"bad-gzip.dump.gz", "compressed (gzip)"},
    {"bad-cut.dump.zst", "compressed dump is cut off"},
    {"bad-plain.dump.zst", "compressed dump is damaged"},
    {"bad-bomb.dump.zst", "longer than 65536 bytes"},
    {"bad-binary.dump", "is binary"},
    {"bad-utf16.dump", "UTF-16"},
    {"bad-escape.dump", "\\x1b]0;owned\\x07"},
    {"bad-decimal-comma.dump", "decimal comma"},
    {"bad-fortran-d.dump", "Fortran's D"},
    {"bad-float-ids.dump", "'1.0' in column id is not a whole number"},
    {"bad-step-overflow.dump", "'99999999999999999999' is not a step"},
    {"bad-negative-steps.dump", "frame at step -100 comes before step 0"},
    {"bad-nan.dump", "is not finite"},
    {"bad-dup-id.dump", "id 1 appears twice"},
    {"bad-lost-atom.dump", "holds 1 atoms, 2 expected"},
    {"bad-restart-repeat.dump", "frames overlap"},
    {"bad-two-bounds.dump", "out of place"},
    {"bad-truncated-number.dump", "ends in the middle"},
    {"bad-no-newline.dump", "ends in the middle"},
    {"bad-blank-end.dump", "a blank line is out of place"},
    {"bad-empty.dump", "holds no frame"},
    {"bad-box-not-periodic.dump", "the box is not periodic along x ('ff')"},
    {"bad-box-other-period.dump", "the box is 24 long along x, the scene has period 12"},
    {"bad-triclinic-tilt.dump", "the box is tilted by 3"},
    {"bad-three-dim.dump", "velocity along z of id 1 is -3.5"},
    {"bad-other-radius.dump", "radius of id 1 is 0.35, the scene's is 1"},
    {"bad-time-other-dt.dump", "with the scene's dt = 0.001 it is 0.1"},
    {"bad-other-start.dump", "x of grain 0 is 1.37 instead of 1"},
    {"bad-swapped-ids.dump", "x of grain 0 is 10.9 instead of 1"},
    {"bad-wrapped-as-xu.dump", "grain 1 moves by 10.77"}};

const std::vector<std::string> accepted{
    "ok-plain.dump",          "ok-packed.dump.zst", "ok-columns.dump",    "ok-crlf.dump",
    "ok-tabs.dump",           "ok-unsorted.dump",   "ok-units-time.dump", "ok-bom.dump",
    "ok-triclinic-zero.dump", "ok-underflow.dump",  "ok-denormal.dump",   "ok-plus-signs.dump",
    "ok-own-older.dump"};

Answer read(const Program& program, const std::string& dump,
            const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"read", inputs + "ring.toml", dump, "--code", "mine"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return program(arguments);
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_dump_of_the_folder_is_played) {
    std::size_t files = 0;
    for (const auto& entry : fs::directory_iterator(inputs + "dumps"))
        files += entry.is_regular_file() ? 1 : 0;
    BOOST_TEST(files == refused.size() + accepted.size());
}

BOOST_DATA_TEST_CASE(a_bad_dump_is_bad_input, data::make(refused), dump) {
    const LimitedProgram program;
    check_refused(read(program, inputs + "dumps/" + dump.file), {dump.file, dump.words});
}

BOOST_DATA_TEST_CASE(an_unusual_dump_is_read, data::make(accepted), dump) {
    const LimitedProgram program;
    const auto answer = read(program, inputs + "dumps/" + dump);
    BOOST_TEST(answer.status == 0, answer.err);
    BOOST_TEST(answer.error_lines() == 0);
}

BOOST_AUTO_TEST_CASE(a_dump_may_have_any_file_name) {
    const LimitedProgram program;
    const std::string path = program.directory() / "b\xe4se\x1b[2J.dump";
    fs::copy_file(inputs + "dumps/ok-plain.dump", path);
    const auto answer = read(program, path, {"--json"});
    BOOST_TEST(answer.status == 0, answer.err);
    BOOST_TEST(nlohmann::json::accept(answer.out));
    check_refused(read(program, path + "\xff"), {"cannot be read", "\\xe4", "\\xff"});
}

BOOST_AUTO_TEST_CASE(what_has_no_end_is_refused) {
    const LimitedProgram program;
    check_refused(read(program, "/dev/zero"), {"device"});
    check_refused(read(program, inputs), {"directory"});
    const auto pipe = program.directory() / "pipe";
    BOOST_TEST_REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    const auto endless = [&](const std::string& start, const std::string& block) {
        const std::jthread writer([&] {
            std::ofstream out(pipe);  // SIGPIPE is ignored below
            out << start;
            while (out << block) {
            }
        });
        return read(program, pipe);
    };
    signal(SIGPIPE, SIG_IGN);
    check_refused(endless("", std::string(4096, '\0')), {"is binary"});
    check_refused(endless("ITEM: TIMESTEP\n0\n", std::string(4096, 'x')),
                  {"line 3", "longer than 65536 bytes"});
    check_refused(endless("", "ITEM: UNITS\nlj\n"), {"out of place"});
    check_refused(endless("", "ITEM: TIMESTEP\n"), {"is not a step"});
}

BOOST_AUTO_TEST_CASE(a_dump_may_come_through_a_pipe) {
    const LimitedProgram program;
    const auto pipe = program.directory() / "pipe";
    BOOST_TEST_REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    const std::jthread writer(
        [&] { std::ofstream(pipe) << std::ifstream(inputs + "dumps/ok-plain.dump").rdbuf(); });
    const auto answer = read(program, pipe);
    BOOST_TEST(answer.status == 0, answer.err);
}
