// Protects what comes out: results that cannot be printed are an error, files of a report are
// written all the same; whatever bytes names and programs hold, JSON, XML and terminal get valid
// text.
#include "tests/app/program.hpp"
#include "tests/support/well_formed_xml.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <set>

using crossgrain::tests::Answer;
using crossgrain::tests::fault_in_xml;
using crossgrain::tests::Program;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void write(const fs::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

/// A small case in two native runs, as "./c.toml" of the program's directory.
void add_case(const Program& crossgrain, const std::string& file = "c.toml") {
    const auto copied = crossgrain.case_with("small-gas", "title = ", "title = ");
    fs::rename(copied, crossgrain.directory() / file);
}

void check_valid_report(const Program& crossgrain) {
    const auto report = crossgrain.results() / "report";
    BOOST_TEST(fs::exists(report / (CROSSGRAIN_PAGES != 0 ? "index.html" : "report.json")));
    BOOST_TEST(fs::exists(report / "verdicts.csv"));
    const std::string junit = text_of(report / "junit.xml");
    BOOST_TEST(!junit.empty());
    BOOST_TEST(fault_in_xml(junit) == "");
}

/// Printed text has no control characters but line feeds, and is UTF-8.
void check_printable(const std::string& text) {
    BOOST_CHECK_NO_THROW((void)json(text).dump());
    for (const char c : text) {
        if (c == '\n') continue;
        BOOST_TEST_REQUIRE(static_cast<unsigned char>(c) >= 0x20U);
    }
    BOOST_TEST(text.find("\xC2\x9B") == std::string::npos);
}

}  // namespace

BOOST_AUTO_TEST_CASE(results_that_cannot_be_printed_are_an_error) {
    const Program crossgrain;
    add_case(crossgrain);
    BOOST_TEST(crossgrain.shell("crossgrain cases").status == 0);
    for (const char* line : {"crossgrain cases >/dev/full", "crossgrain --json cases >/dev/full",
                             "crossgrain --help >/dev/full",
                             "crossgrain --json run ./c.toml --code native-dem >/dev/full",
                             "crossgrain --json history >/dev/full"}) {
        const Answer answer = crossgrain.shell(line);
        BOOST_TEST(answer.status == 3, line);
        BOOST_TEST(answer.error_lines() == 1, line);
        BOOST_TEST(answer.says("error: standard output cannot be written: No space left"), line);
    }
    BOOST_TEST(crossgrain.shell("crossgrain cases >&-").says("Bad file descriptor"));
    BOOST_TEST(
        crossgrain.shell("{ crossgrain cases; echo $? >status; } | true").says("Broken pipe"));
    BOOST_TEST(text_of(crossgrain.directory() / "status") == "3\n");
    // What could not be printed was stored.
    BOOST_TEST(crossgrain({"run", "./c.toml", "--code", "native-dem"}).says("0 runs computed"));
}

BOOST_AUTO_TEST_CASE(a_report_is_written_before_anything_is_printed) {
    for (const char* where : {">/dev/full", ">&-", "| true"}) {
        const Program crossgrain;
        add_case(crossgrain);
        const std::string validate = "crossgrain validate ./c.toml --code native-dem ";
        BOOST_TEST(crossgrain.shell(validate + where).error_lines() == 1, where);
        check_valid_report(crossgrain);
    }
}

BOOST_AUTO_TEST_CASE(notes_that_cannot_be_printed_are_not_missed) {
    for (const char* where : {"2>/dev/full", "2>&-"}) {
        const Program crossgrain;
        add_case(crossgrain);
        const Answer answer =
            crossgrain.shell(std::string("crossgrain run ./c.toml --code native-dem ") + where);
        BOOST_TEST(answer.status == 0, where);
        BOOST_TEST(answer.says("1 agree"), where);
    }
}

BOOST_AUTO_TEST_CASE(a_report_that_cannot_be_written_does_not_hide_the_verdicts) {
    const Program crossgrain;
    add_case(crossgrain);
    const std::vector<std::string> validate{"validate", "./c.toml", "--code", "native-dem"};
    BOOST_TEST(crossgrain(validate).status == 0);
    fs::remove_all(crossgrain.results() / "report");
    write(crossgrain.results() / "report", "a file in the way");
    const Answer answer = crossgrain(validate);
    BOOST_TEST(answer.status == 3);
    BOOST_TEST(answer.error_lines() == 1);
    BOOST_TEST(answer.says("1 agree"));
    BOOST_TEST(answer.says("report': Not a directory"));
    BOOST_TEST(crossgrain({"report", "./c.toml"}).status == 3);
    BOOST_TEST(crossgrain({"compare", "./c.toml", "--code", "native-dem"}).status == 0);
}

BOOST_AUTO_TEST_CASE(whatever_a_program_calls_its_version_the_output_is_valid) {
    Program crossgrain;
    add_case(crossgrain);
    fs::create_directory(crossgrain.directory() / "bin");
    const auto program = crossgrain.directory() / "bin/lmp";
    write(program, "#!/bin/sh\nprintf 'Large-scale Simulator - 1 "
                   "\\377\\033[31m\\302\\233\\357\\277\\276<&\"\\n granular\\n'\n");
    fs::permissions(program, fs::perms::owner_all);
    crossgrain.environment = {"PATH=" + program.parent_path().string() + ":/usr/bin:/bin"};
    const std::vector<std::string> validate{"validate", "./c.toml",   "--code", "lammps",
                                            "--code",   "native-dem", "--json"};
    for (int call = 0; call < 2; ++call) {  // the second takes from the store
        const json runs = json::parse(crossgrain(validate).out)["cases"][0]["runs"];
        BOOST_TEST(runs.size() == 2U);
        for (const auto& run : runs) {
            if (run["code"] != "lammps") continue;
            BOOST_TEST(run["version"] == "1 \\xff\\x1b[31m\\x9b\\u{fffe}<&\"");
        }
        check_valid_report(crossgrain);
    }
    BOOST_TEST(json::accept(crossgrain({"codes", "--json"}).out));
    check_printable(crossgrain({"codes"}).out);
    const Answer answer = crossgrain({"run", "./c.toml", "--code", "lammps"});
    check_printable(answer.out);
    check_printable(answer.err);
}

BOOST_AUTO_TEST_CASE(file_names_of_any_bytes_come_out_valid) {
    const Program crossgrain;
    add_case(crossgrain, "caf\xE9\x1B.toml");
    const std::string file = "./caf\xE9\x1B.toml";
    const Answer kept =
        crossgrain({"validate", file, "--code", "native-dem", "--keep-dumps", "--json"});
    BOOST_TEST(kept.status == 0);
    BOOST_TEST(json::accept(kept.out));
    check_printable(kept.err);
    check_valid_report(crossgrain);
    fs::path dump;
    for (const auto& entry : fs::recursive_directory_iterator(crossgrain.results())) {
        if (entry.path().filename() == "dump.txt.zst") dump = entry.path();
    }
    const auto renamed = crossgrain.directory() / "d\xFF\xC2\x9B.dump.zst";
    fs::copy_file(dump, renamed);
    const Answer read = crossgrain({"read", file, renamed.string(), "--code", "m", "--json"});
    BOOST_TEST(read.status == 0);
    const std::string named =
        json::parse(read.out)["cases"][0]["runs"][0]["settings"]["dump"].get<std::string>();
    BOOST_TEST(named.ends_with("d\\xff\\x9b.dump.zst"));
    check_printable(crossgrain({"run", "./no\xFF\x1B.toml"}).err);
    check_printable(crossgrain({"--no\xFF\x1B"}).err);
}

BOOST_AUTO_TEST_CASE(the_recorded_command_is_one_word_per_argument) {
    const Program crossgrain;
    const std::string name = "it's; a \xFF$(case).toml";
    add_case(crossgrain, name);
    const Answer answer = crossgrain({"validate", "./" + name, "--code", "native-dem"});
    BOOST_TEST(answer.status == 0);
    const std::string data = text_of(crossgrain.results() / "report" /
                                     (CROSSGRAIN_PAGES != 0 ? "data.js" : "report.json"));
    const std::string recorded =
        R"(crossgrain validate './it'\\''s; a \\xff$(case).toml' --code native-dem)";
    BOOST_TEST((data.find(recorded) != std::string::npos));
}

BOOST_AUTO_TEST_CASE(inputs_of_different_runs_never_share_a_directory) {
    const Program crossgrain;
    const auto file =
        crossgrain.case_with("small-gas", "[[observable]]\nname = \"trajectory\"",
                             "[[variant]]\nname = \"a/b\"\nscene.contact.restitution = 0.5\n"
                             "[[variant]]\nname = \"a b\"\nscene.contact.restitution = 0.6\n"
                             "[[variant]]\nname = \"a-b\"\nscene.contact.restitution = 0.7\n"
                             "[[observable]]\nname = \"trajectory\"");
    const auto write_to = [&](const std::string& out, const char* code) {
        return crossgrain({"write", file, "--code", code, "--out", out});
    };
    const auto out = crossgrain.directory() / "inputs";
    BOOST_TEST(write_to(out.string(), "native-dem").status == 0);
    std::set<std::string> contents;
    for (const auto& entry : fs::directory_iterator(out))
        contents.insert(text_of(entry.path() / "scene.json"));
    BOOST_TEST(contents.size() == 3U);
    // The same again is fine, also where results lie beside the input; another is not mixed in.
    write(fs::directory_iterator(out)->path() / "log", "of a run");
    BOOST_TEST(write_to(out.string(), "native-dem").status == 0);
    for (const auto& impossible : {out.string(), std::string("/dev/null/x"), file}) {
        const Answer refused = write_to(impossible, "lammps");
        BOOST_TEST(refused.status == 2, impossible);
        BOOST_TEST(refused.error_lines() == 1, impossible);
        BOOST_TEST(refused.says(impossible));
    }
}

BOOST_AUTO_TEST_CASE(stability_says_before_it_computes_that_a_case_has_none) {
    const Program crossgrain;
    const Answer answer = crossgrain({"stability", "collision-normal", "--code", "native-dem"});
    BOOST_TEST(answer.status == 2);
    BOOST_TEST(answer.error_lines() == 1);
    BOOST_TEST(answer.says("expected a bed or a lattice"));
    BOOST_TEST(!fs::exists(crossgrain.results()));
}
