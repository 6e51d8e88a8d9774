// Protects `crossgrain read`: a dump made elsewhere is measured like any run, and a damaged one is
// bad input with its reason, never a number.
#include "tests/app/program.hpp"
#include "tests/support/zstd_text.hpp"

#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <functional>

using crossgrain::tests::Answer;
using crossgrain::tests::Program;
using nlohmann::json;

namespace {

/// Runs the small gas natively, keeps its dump, and hands out changed copies of it.
class DumpedGas {
  public:
    DumpedGas() : case_file_(crossgrain_.case_with("small-gas", "name = ", "name = ")) {
        const auto answer =
            crossgrain_({"run", case_file_, "--code", "native-dem", "--keep-dumps", "--quiet"});
        BOOST_REQUIRE(answer.status == 0);
        for (const auto& entry :
             std::filesystem::recursive_directory_iterator(crossgrain_.results())) {
            if (entry.path().filename() == "dump.txt.zst")
                text_ = crossgrain::tests::unpacked_file(entry.path());
        }
        BOOST_REQUIRE(!text_.empty());
    }

    [[nodiscard]] Answer measured(const std::function<void(std::string&)>& change) const {
        std::string text = text_;
        change(text);
        const auto path = crossgrain_.directory() / "changed.dump";
        std::ofstream(path) << text;
        return crossgrain_({"read", case_file_, path.string(), "--code", "mine", "--json"});
    }

  private:
    Program crossgrain_;
    std::string case_file_;
    std::string text_;
};

void check_failed(const Answer& answer, const std::string& reason) {
    BOOST_TEST(answer.status == 2);  // bad input, not a run of ours
    BOOST_TEST(answer.error_lines() == 1);
    const json runs = json::parse(answer.out)["cases"][0]["runs"];
    BOOST_TEST(runs[0]["status"] == "run_failed");
    const std::string found = runs[0]["reason"];
    BOOST_TEST((found.find(reason) != std::string::npos), found);
}

void replace(std::string& text, const std::string& from, const std::string& to) {
    const auto at = text.rfind(from);
    BOOST_REQUIRE(at != std::string::npos);
    text.replace(at, from.size(), to);
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_undamaged_dump_agrees_with_the_run_that_made_it) {
    const Answer answer = DumpedGas().measured([](std::string&) {});
    BOOST_TEST(answer.status == 0);
    bool compared = false;
    const json verdicts = json::parse(answer.out)["cases"][0]["verdicts"];
    for (const auto& verdict : verdicts) {
        BOOST_TEST(verdict["verdict"] == "agree");
        if (verdict["kind"] == "parity") {
            compared = true;
            BOOST_TEST(verdict["difference"] == 0.0);
        }
    }
    BOOST_TEST(compared);
}

BOOST_AUTO_TEST_CASE(a_damaged_dump_is_a_failed_run) {
    const DumpedGas gas;
    check_failed(gas.measured([](std::string& t) { t.resize(t.size() - 200); }), "ends");
    check_failed(gas.measured([](std::string& t) {
        const auto line = t.rfind("\n1 1 ") + 5;
        t.replace(line, t.find(' ', line) - line, "nan");
    }),
                 "finite");
    check_failed(gas.measured([](std::string& t) {
        replace(t, "ITEM: NUMBER OF ATOMS\n16", "ITEM: NUMBER OF ATOMS\n15");
    }),
                 "15");
    check_failed(gas.measured([](std::string& t) { t += t; }), "overlap");
    check_failed(gas.measured([](std::string& t) {
        for (auto at = t.find(" vx"); at != std::string::npos; at = t.find(" vx")) {
            t.replace(at, 3, " wx");
        }
    }),
                 "vx");
    check_failed(gas.measured([](std::string& t) { t.clear(); }), "");
}

BOOST_AUTO_TEST_CASE(a_trajectory_that_differs_disagrees) {
    const Answer answer = DumpedGas().measured([](std::string& t) {
        // the last frame's first grain, far less than a guard can see further
        const auto line = t.rfind("\n1 1 ") + 5;
        const auto length = t.find(' ', line) - line;
        const double moved = std::stod(t.substr(line, length)) + 1e-5;
        t.replace(line, length, fmt::format("{:.17g}", moved));
    });
    BOOST_TEST(answer.status == 1);
    BOOST_TEST(answer.says("disagree"));
}
