// Case files that ask for what must not happen: commands in names, paths that end early, sizes
// beyond all memory, nesting without end. Each is refused in one line, at once, and nothing in the
// results directory is touched.
#include "tests/hostile/limited_program.hpp"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>

#include <ostream>
#include <thread>

#include <sys/stat.h>

using namespace crossgrain::tests;
namespace data = boost::unit_test::data;

namespace {

/// One edit of a case that runs, and what is said of it.
struct Edit {
    const char* shows;
    std::string from, to;
    std::vector<std::string> words;
};

std::ostream& operator<<(std::ostream& out, const Edit& edit) {
    return out << edit.shows;
}

std::string repeated(const std::string& part, int times) {
    std::string text;
    for (int i = 0; i < times; ++i)
        text += part;
    return text;
}

std::string axis(const char* key) {
    std::string text = std::string(key) + " = [";
    for (int i = 1; i <= 200; ++i)
        text += std::to_string(i) + ",";
    return text + "]\n";
}

const std::string name = "name = \"small-gas\"", gas = R"("gas", count = 16)";
const std::string contact = "[scene.contact]", variant = "[[variant]]\nname = ";

const std::vector<Edit> edits{
    {"NUL in a name", name, R"(name = "..\u0000x")", {"'name'", "\\x00"}},
    {"NUL as a name", name, R"(name = "\u0000")", {"'name'"}},
    {"no name", name, "name = \"\"", {"'name' is empty"}},
    {"long name", name, "name = \"" + std::string(5000, 'x') + "\"", {"too long", "120"}},
    {"escape in a name", name, R"(name = "\u001b]0;owned\u0007")", {"'name'", "\\x1b"}},
    {"noncharacter in a name", name, R"(name = "x\uFFFE")", {"'name'", "\\u{fffe}"}},
    {"raw byte in a name", name, "name = \"x\x80\"", {"not valid TOML"}},
    {"direction mark in a title", "title = \"", "title = \"\\u202e", {"'title'"}},
    {"escape in the text", "text = \"", "text = \"\\u001b[2J", {"'text'"}},
    {"escape in a reason", "reason = \"", "reason = \"\\u001b[2J", {"'check.reason'"}},
    {"command in a variant",
     contact,
     variant + R"("x\nshell touch pwned\n#")" + "\n" + contact,
     {"'variant.name'", "\\nshell"}},
    {"python in a variant",
     contact,
     variant + R"("x\"\"\"\nimport os")" + "\n" + contact,
     {"'variant.name'"}},
    {"escape in an unknown key", contact, "\"\\u001b[2J\" = 1\n" + contact, {"not a known key"}},
    {"escape in a swept text",
     contact,
     "[sweep]\nintegrator = [\"\\u001b[2J\"]\n" + contact,
     {"'sweep.integrator'"}},
    {"escape in a code's name",
     contact,
     "[replicas]\n\"a\\u001b[2J\" = 1\n" + contact,
     {"'replicas'"}},
    {"key and key inside it",
     contact,
     "[sweep]\na = [1.0]\n\"a.b\" = [1.0]\n" + contact,
     {"sweep.a.b", "'a'"}},
    {"empty key in a sweep",
     contact,
     "[sweep]\n\"\" = [1.0]\n\".\" = [2.0]\n" + contact,
     {"empty"}},
    {"sweep of tables", contact, "[sweep]\ndt = [{ a = 1 }]\n" + contact, {"'sweep.dt'"}},
    {"200^5 combinations",
     contact,
     "[sweep]\n" + axis("gravity") + axis("drag") + axis("gamma") + axis("skin") + axis("dt") +
         contact,
     {"3.2e+11", "100000"}},
    {"replicas that overflow",
     contact,
     "[replicas]\ndefault = 100000\n[replicas_in]\n\"*\" = 100000\n" + contact,
     {"'replicas'", "100000"}},
    {"replicas beyond 62 bits",
     contact,
     "[replicas]\ndefault = 4611686018427387904\n" + contact,
     {"'replicas.default'", "100000"}},
    {"deep header", contact, "[" + repeated("a.", 100'000) + "a]\n" + contact, {"too deeply"}},
    {"deep key", contact, repeated("a.", 100'000) + "a = 1\n" + contact, {"too deeply"}},
    {"deep array", contact, "a = " + repeated("[", 100'000) + "\n" + contact, {"too deeply"}},
    {"deep inline tables",
     contact,
     "a = " + repeated("{a=", 100'000) + "\n" + contact,
     {"too deeply"}},
    {"1e12 grains", gas, R"("gas", count = 1000000000000)", {"scene.initial.count", "10000000"}},
    {"2e12 discs of a wall",
     gas + ", velocity_spread = 3.0",
     R"("pipe", width = 1e2, wall_spacing = 1e-9, area_fraction = 0.1, velocity_spread = 1.0)",
     {"scene.initial"}},
    {"1e18 frames", "contact_times = 5.0", "contact_times = 1e300", {"too long"}},
    {"too many frames",
     "dt = 1e-3\ncontact_times = 5.0\nframes = { every_contact_times = 0.1 }",
     "dt = 1e-3\ntime = 1e6\nframes = { every_steps = 1 }",
     {"too many frames", "10000000"}},
    {"grains beyond all digits",
     gas + ", velocity_spread = 3.0",
     R"("explicit", x = [0.0, 1e12], y = [0.0, 0.0], vx = [0.0, 0.0], vy = [0.0, 0.0])",
     {"farther than"}},
    {"infinite number", "gravity = 0.0", "gravity = inf", {"'scene.gravity'"}},
    {"integer beyond 64 bits", gas, R"("gas", count = 99999999999999999999)", {"not valid TOML"}},
    {"file of 20 MB", name, name + "\n#" + std::string(20'000'000, 'x'), {"too long", "16 MiB"}}};

const std::string pipe_of_gas = R"(name = "gas"
title = "t"
source = "s"
text = "t"
suites = ["full"]
time_limit = 1.0
model = "lattice-gas"
[scene]
length = 220
width = 11
ends = "periodic"
density = 1.0
dissipation = 0.1
gravity = 0.5
roughness = 0.5
reading = "D"
sample = { bin = 2, replicas = 512, steps = 10, every = 5 }
)";

std::string written(const Program& program, const std::string& text) {
    const auto path = program.directory() / "input.toml";
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

}  // namespace

BOOST_DATA_TEST_CASE(a_hostile_case_is_refused_and_touches_nothing, data::make(edits), edit) {
    const LimitedProgram program;
    std::filesystem::create_directories(program.results() / "runs");
    const auto kept = program.results() / "kept", kept_run = program.results() / "runs" / "kept";
    std::ofstream(kept) << "mine";
    std::ofstream(kept_run) << "mine";
    const auto file = program.case_with("small-gas", edit.from, edit.to);
    check_refused(program({"run", file, "--code", "native-dem", "--keep-dumps"}), edit.words);
    BOOST_TEST(std::filesystem::exists(kept));
    BOOST_TEST(std::filesystem::exists(kept_run));
}

BOOST_AUTO_TEST_CASE(a_gas_beyond_all_memory_is_refused) {
    const LimitedProgram program;
    check_refused(
        program({"run", written(program, replaced(replaced(pipe_of_gas, "220", "10000000"),
                                                  "width = 11", "width = 100"))}),
        {"scene.length", "TiB"});
    check_refused(program({"run", written(program, replaced(pipe_of_gas, "density = 1.0",
                                                            "density = 1e-4"))}),
                  {"scene.density", "empty pipe"});
    check_refused(program({"run", written(program, replaced(pipe_of_gas, "[scene]",
                                                            "[[observable]]\nname = \"spectrum\"\n"
                                                            "points = 1e300\n[scene]"))}),
                  {"observable"});
}

BOOST_AUTO_TEST_CASE(what_is_no_case_file_is_refused_for_what_it_is) {
    const LimitedProgram program;
    using namespace std::string_literals;
    check_refused(program({"run", "/dev/zero"}), {"device"});
    check_refused(program({"run", program.directory().string() + "/"}), {"directory"});
    check_refused(program({"run", written(program, "\xff\xfen\0a\0"s)}), {"UTF-16"});
    check_refused(program({"run", written(program, "\x1f\x8b\x08"s)}), {"gzip"});
    check_refused(program({"run", written(program, "name = \0"s)}), {"binary"});
    check_refused(program({"run", written(program, "")}), {"missing"});
    check_refused(program({"run", "\x1b[2J\xff"}), {"unknown case"});
}

BOOST_AUTO_TEST_CASE(numbers_on_the_command_line_are_what_was_typed) {
    const LimitedProgram program;
    const auto file = program.case_with("small-gas", name, name);
    const std::vector<std::pair<std::string, std::vector<std::string>>> refused{
        {"--seed", {"-1", "18446744073709551616", "1e3", "0x10", "", " 1", "one"}},
        {"--replicas", {"0", "-1", "1e9", "100001", "99999999999999999999"}},
        {"--time-limit", {"nan", "inf", "1e400", "0", "-1", "1e300"}},
        {"--jobs", {"0", "-1", "1000000000"}}};
    for (const auto& [option, values] : refused) {
        for (const auto& value : values)
            check_refused(program({"run", file, option + "=" + value}), {option, "expected"});
    }
    check_refused(program({"read", file, "x", "--code", "a\x1b[2J"}), {"--code"});
    check_refused(program({"read", file, "x", "--code", "m", "--rung", "-1"}), {"--rung"});
    check_refused(program({"write", file, "--code", "native-dem", "--out", "a\nb"}), {"--out"});
    check_refused(program({"\x1b[2J"}), {"--help"});
    const auto accepted =
        program({"run", file, "--code", "native-dem", "--seed", "9223372036854675807", "--jobs",
                 "1000", "--time-limit", "1e9", "--replicas", "1"});
    BOOST_TEST(accepted.status == 0, accepted.err);
}

BOOST_AUTO_TEST_CASE(a_name_with_umlauts_is_a_name) {
    const LimitedProgram program;
    const auto file = program.case_with("small-gas", name, "name = \"\u00dcbung \u03b8/1\"");
    const auto answer = program({"run", file, "--code", "native-dem", "--json", "--keep-dumps"});
    BOOST_TEST(answer.status == 0, answer.err);
    BOOST_TEST(answer.says("\u00dcbung \u03b8/1"));
}

BOOST_AUTO_TEST_CASE(a_case_may_come_through_a_pipe) {
    const LimitedProgram program;
    const auto file = program.case_with("small-gas", name, name);
    const auto pipe = program.directory() / "pipe";
    BOOST_TEST_REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    const std::jthread writer([&] { std::ofstream(pipe) << std::ifstream(file).rdbuf(); });
    const auto answer = program({"run", pipe.string(), "--code", "native-dem"});
    BOOST_TEST(answer.status == 0, answer.err);
}
