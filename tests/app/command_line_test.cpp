// Protects the interface: every kind of bad input gives one clear line and exit code 2, absent
// codes and failed runs exit 3, nothing already computed is lost or computed twice.
#include "tests/app/program.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

using crossgrain::tests::Answer;
using crossgrain::tests::Program;
using nlohmann::json;

namespace {

/// Exit code 2, one error line, and all of the given words in it.
void check_refused(const Answer& answer, const std::vector<std::string>& words) {
    BOOST_TEST(answer.status == 2);
    BOOST_TEST(answer.error_lines() == 1);
    for (const auto& word : words)
        BOOST_TEST(answer.says(word), "missing: " + word + answer.err);
}

void check_case_refused(const std::string& from, const std::string& to,
                        const std::vector<std::string>& words) {
    const Program crossgrain;
    check_refused(crossgrain({"run", crossgrain.case_with("small-gas", from, to)}), words);
}

}  // namespace

BOOST_AUTO_TEST_CASE(bad_case_files_are_refused_with_place_and_hint) {
    check_case_refused("restitution = 0.8", "restitutoin = 0.8",
                       {"small-gas.toml:", "restitutoin", "did you mean 'restitution'?"});
    check_case_refused("restitution = 0.8", "restitution = 0.0",
                       {"scene.contact.restitution", "(0, 1]"});
    check_case_refused("restitution = 0.8", "restitution = 1.2", {"1.2", "(0, 1]"});
    check_case_refused("restitution = 0.8\ncontact_time = 0.1",
                       "stiffness = -5.0\ndamping_coefficient = 1.0",
                       {"scene.contact.stiffness", "-5", "> 0"});
    check_case_refused("frames = { every_contact_times = 0.1 }",
                       "frames = { every_contact_times = 0.1, every_time = 0.1 }", {"contradicts"});
    check_case_refused("dt = 1e-3", "dt = \"small\"", {"wrong type", "small"});
    check_case_refused("name = \"momentum\"", "name = \"momentun\"",
                       {"momentun", "did you mean \"momentum\"?"});
    check_case_refused("gravity = 0.0", "gravity = ", {"not valid TOML"});
}

BOOST_AUTO_TEST_CASE(unknown_names_are_refused_with_a_hint) {
    const Program crossgrain;
    check_refused(crossgrain({"run", "colision-normal"}), {"did you mean 'collision-normal'?"});
    check_refused(crossgrain({"run", "gas-parity", "--code", "lamps"}), {"did you mean 'lammps'?"});
    check_refused(crossgrain({"run", "/nonexistent/case.toml"}), {"cannot be read"});
    check_refused(crossgrain({"validte"}),
                  {"'validte' is no command or option", "did you mean 'validate'?"});
    check_refused(crossgrain({"--nonsense"}), {"'--nonsense' is no command or option"});
    BOOST_TEST(crossgrain({"run", "--nonsense"}).status == 2);
    BOOST_TEST(crossgrain({}).status == 2);
}

BOOST_AUTO_TEST_CASE(advice_needs_a_chart_and_says_which) {
    const Program crossgrain;
    std::filesystem::create_directories(crossgrain.results());
    const Answer answer = crossgrain({"advise", "collision-normal", "--observable", "restitution",
                                      "--tolerance", "0.01", "--quiet"});
    BOOST_TEST(answer.status == 3);
    BOOST_TEST(answer.error_lines() == 1);
    BOOST_TEST(answer.says("run 'crossgrain chart collision-normal' first"));
    check_refused(crossgrain({"chart", "wall-bounce"}),
                  {"wall-bounce.toml", "chart", "is missing"});
    check_refused(crossgrain({"stability", "pipe-gas-fig6", "--map", "density,colour"}),
                  {"--map", "'colour'", "density"});
}

BOOST_AUTO_TEST_CASE(a_second_run_computes_nothing_and_prints_the_same) {
    const Program crossgrain;
    const auto file = crossgrain.case_with("small-gas", "name = ", "name = ");
    const std::vector<std::string> command{"run", file, "--code", "native-dem", "--json"};
    const Answer first = crossgrain(command);
    BOOST_TEST(first.says("1 runs computed, 0 taken"));
    const Answer second = crossgrain(command);
    BOOST_TEST(second.says("0 runs computed, 1 taken"));
    const auto a = json::parse(first.out);
    const auto b = json::parse(second.out);
    BOOST_TEST(a["cases"][0]["measurements"] == b["cases"][0]["measurements"]);
    BOOST_TEST(a["cases"][0]["verdicts"] == b["cases"][0]["verdicts"]);
    auto fresh = command;
    fresh.emplace_back("--fresh");
    BOOST_TEST(crossgrain(fresh).says("1 runs computed, 0 taken"));
}

BOOST_AUTO_TEST_CASE(an_absent_code_is_not_installed_and_never_green) {
    Program crossgrain;
    crossgrain.environment = {"PATH=/nonexistent"};
    const auto file = crossgrain.case_with("small-gas", "name = ", "name = ");
    const Answer all = crossgrain({"run", file, "--json"});
    BOOST_TEST(all.status == 1);
    int absent = 0;
    const json verdicts = json::parse(all.out)["cases"][0]["verdicts"];
    for (const auto& verdict : verdicts) {
        const bool names_native_only =
            verdict["code"] == "native-dem" && verdict["kind"] == "exact";
        BOOST_TEST((verdict["verdict"] == "agree") == names_native_only);
        absent += verdict["verdict"] == "not_installed" ? 1 : 0;
    }
    BOOST_TEST(absent == 9);  // 6 pairs and 3 codes
    BOOST_TEST(crossgrain({"run", file, "--code", "yade"}).status == 3);
    const json codes = json::parse(crossgrain({"codes", "--json"}).out)["codes"];
    BOOST_TEST(codes.size() == 7U);
    for (const auto& code : codes) {
        const auto name = code["code"].get<std::string>();
        const bool ours = name.starts_with("native-") || name == "synthetic";
        BOOST_TEST(code["status"] == (ours ? "ok" : "not_installed"), name);
    }
}

BOOST_AUTO_TEST_CASE(an_absurd_time_step_is_a_failed_run_with_a_reason) {
    const Program crossgrain;
    const auto file = crossgrain.case_with(
        "small-gas", "dt = 1e-3\ncontact_times = 5.0\nframes = { every_contact_times = 0.1 }",
        "dt = 10.0\ntime = 1000.0\nframes = { every_time = 10.0 }");
    // every installed code, within its time limit
    const Answer answer = crossgrain({"run", file, "--json", "--time-limit", "20"});
    BOOST_TEST(answer.status == 3);
    const json runs = json::parse(answer.out)["cases"][0]["runs"];
    BOOST_TEST(runs.size() == 4U);
    for (const auto& run : runs) {
        if (run["status"] == "not_installed") continue;
        BOOST_TEST(run["status"] == "run_failed");
        BOOST_TEST(!run["reason"].get<std::string>().empty());
        BOOST_TEST_MESSAGE(run["reason"]);
    }
}

BOOST_AUTO_TEST_CASE(an_unwritable_results_directory_is_refused) {
    const Program crossgrain;
    std::ofstream(crossgrain.results()) << "a file in the way";
    check_refused(crossgrain({"run", "gas-parity", "--code", "native-dem"}), {"results"});
}

BOOST_AUTO_TEST_CASE(a_damaged_store_is_refused) {
    const Program crossgrain;
    std::filesystem::create_directories(crossgrain.results());
    std::ofstream(crossgrain.results() / "crossgrain.db") << std::string(4096, 'x');
    check_refused(crossgrain({"history"}), {"results directory"});
}

BOOST_AUTO_TEST_CASE(inputs_are_written_for_every_code) {
    const Program crossgrain;
    const auto file = crossgrain.case_with("small-gas", "name = ", "name = ");
    for (const char* code : {"native-dem", "lammps", "liggghts", "yade"}) {
        const auto out = crossgrain.directory() / code;
        BOOST_TEST(crossgrain({"write", file, "--code", code, "--out", out.string()}).status == 0);
        BOOST_TEST(!std::filesystem::is_empty(out));
    }
    check_refused(crossgrain({"write", file, "--out", "x"}), {"--code"});
}

BOOST_AUTO_TEST_CASE(an_empty_history_is_no_error) {
    const Program crossgrain;
    std::filesystem::create_directories(crossgrain.results());
    const Answer answer = crossgrain({"history", "--json"});
    BOOST_TEST(answer.status == 0);
    BOOST_TEST(json::parse(answer.out)["series"].empty());
}
