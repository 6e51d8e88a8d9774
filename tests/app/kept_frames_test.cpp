// A run whose frames were kept is measured again without its code, to the same bits; frames that
// are not what was kept are refused, and the code runs.
#include "adapters/lammps/lammps_code.hpp"
#include "tests/app/program.hpp"
#include "tests/support/external_code.hpp"
#include "tests/support/zstd_text.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace fs = std::filesystem;
using crossgrain::tests::Answer;
using crossgrain::tests::bytes_of;
using crossgrain::tests::Program;
using nlohmann::json;

using NeedsLammps = crossgrain::tests::NeedsCode<crossgrain::adapters::LammpsCode>;
BOOST_TEST_GLOBAL_FIXTURE(NeedsLammps);

namespace {

/// The small gas in LAMMPS, which leaves a line in a file at every start with an input.
class KeptGas {
  public:
    KeptGas() {
        const fs::path bin = crossgrain.directory() / "bin";
        fs::create_directories(bin);
        std::ofstream script(bin / "lmp");
        script << "#!/bin/sh\nif [ -f in.lammps ]; then echo started >>'" << starts_.string()
               << "'; fi\nPATH=\"" << std::getenv("PATH") << "\" exec lmp \"$@\"\n";
        script.close();
        fs::permissions(bin / "lmp", fs::perms::owner_all);
        crossgrain.environment = {"PATH=" + bin.string() + ":" + std::getenv("PATH")};
    }

    /// Runs the case with further observables, which change the key of the run as a change of an
    /// estimator does.
    [[nodiscard]] Answer run(const std::string& observables,
                             const std::vector<std::string>& more = {}) const {
        std::vector<std::string> command{
            "run", crossgrain.case_with("small-gas", "[[check]]", observables + "[[check]]"),
            "--code", code, "--json"};
        command.insert(command.end(), more.begin(), more.end());
        return crossgrain(command);
    }
    /// How often LAMMPS was started with an input.
    [[nodiscard]] std::size_t starts() const {
        const std::string lines = bytes_of(starts_);
        return static_cast<std::size_t>(std::ranges::count(lines, '\n'));
    }
    [[nodiscard]] fs::path dump() const {
        fs::path found;
        for (const auto& entry : fs::recursive_directory_iterator(crossgrain.results() / "runs"))
            if (entry.path().filename() == "dump.txt.zst") found = entry.path();
        BOOST_TEST_REQUIRE(!found.empty());
        return found;
    }

    Program crossgrain;
    std::string code = "lammps";

  private:
    fs::path starts_ = crossgrain.directory() / "starts";
};

const std::string energy = "[[observable]]\nname = \"energy-balance\"\n\n";
const std::string later = "[[observable]]\nname = \"trajectory\"\nat_contact_times = [4.0]\n\n";

json run_of(const Answer& answer) {
    return json::parse(answer.out)["cases"][0]["runs"][0];
}

std::map<std::string, double> values_of(const Answer& answer) {
    std::map<std::string, double> values;
    const json measurements = json::parse(answer.out)["cases"][0]["measurements"];
    for (const auto& m : measurements)
        values[m["observable"]] = m["value"];
    return values;
}

}  // namespace

BOOST_AUTO_TEST_CASE(other_observables_are_measured_without_starting_the_code) {
    const KeptGas gas;
    const Answer first = gas.run("", {"--keep-dumps"});
    BOOST_TEST_REQUIRE(first.status == 0, first.err);
    BOOST_TEST(gas.starts() == 1u);
    BOOST_TEST(run_of(first)["measured_again"] == false);
    const Answer again = gas.run(energy);
    BOOST_TEST(again.status == 0, again.err);
    BOOST_TEST(again.says("1 runs measured again from kept frames"), again.err);
    BOOST_TEST(again.says("0 runs computed, 0 taken"), again.err);
    BOOST_TEST(gas.starts() == 1u);
    for (const char* same : {"cpu_s", "wall_s", "version", "program", "digest", "seed"})
        BOOST_TEST(run_of(again)[same] == run_of(first)[same], same);
    BOOST_TEST(run_of(again)["measured_again"] == true);
    auto before = values_of(first), after = values_of(again);
    BOOST_TEST(before.contains("momentum_drift_x"));
    BOOST_TEST(after.size() > before.size());
    for (const auto& [name, value] : before)
        BOOST_TEST(after.at(name) == value, name);
    // As LAMMPS gives them when it is run.
    const Answer fresh = gas.run(energy, {"--fresh"});
    BOOST_TEST(gas.starts() == 2u);
    BOOST_TEST((values_of(fresh) == after));
    BOOST_TEST(gas.run(energy).says("0 runs computed, 1 taken"));
    BOOST_TEST(gas.starts() == 2u);
}

BOOST_AUTO_TEST_CASE(another_scene_or_program_has_other_frames) {
    const KeptGas gas;
    BOOST_TEST(gas.run("", {"--keep-dumps"}).status == 0);
    BOOST_TEST(gas.run(energy, {"--seed", "2"}).says("1 runs computed"));
    BOOST_TEST(gas.starts() == 2u);
    std::ofstream(gas.crossgrain.directory() / "bin" / "lmp", std::ios::app) << "# changed\n";
    BOOST_TEST(gas.run(energy).says("1 runs computed"));
    BOOST_TEST(gas.starts() == 3u);
}

BOOST_AUTO_TEST_CASE(frames_are_not_kept_unless_asked_for_or_if_the_run_fails) {
    const KeptGas gas;
    BOOST_TEST(gas.run("").status == 0);
    BOOST_TEST(gas.run(energy).says("1 runs computed"));
    BOOST_TEST(gas.starts() == 2u);
    BOOST_TEST(gas.run("", {"--fresh", "--keep-dumps", "--time-limit", "0.001"}).status == 3);
    BOOST_TEST(gas.run(later).says("1 runs computed"));
}

BOOST_AUTO_TEST_CASE(frames_that_were_cut_off_or_altered_are_refused_and_the_code_runs) {
    const KeptGas gas;
    BOOST_TEST(gas.run("", {"--keep-dumps"}).status == 0);
    const std::string whole = bytes_of(gas.dump());
    std::ofstream(gas.dump(), std::ios::binary) << whole.substr(0, whole.size() - 100);
    const Answer cut = gas.run(energy, {"--keep-dumps"});
    BOOST_TEST(cut.status == 0);
    BOOST_TEST(cut.says("cannot be measured again (dump.txt.zst holds"), cut.err);
    BOOST_TEST(cut.says("1 runs computed"));
    BOOST_TEST(gas.starts() == 2u);
    // That run has left its own frames instead.
    std::string text = crossgrain::tests::unpacked_file(gas.dump());
    text.replace(text.rfind("\n1 1 ") + 5, 1, "9");
    crossgrain::tests::pack_into(gas.dump(), text);
    const Answer altered = gas.run(later);
    BOOST_TEST(altered.status == 0);
    BOOST_TEST(altered.says("the frames kept in "), altered.err);
    BOOST_TEST(altered.says("1 runs computed"));
    BOOST_TEST(gas.starts() == 3u);
}

BOOST_AUTO_TEST_CASE(our_own_engine_keeps_frames_as_well) {
    KeptGas gas;
    gas.code = "native-dem";
    const Answer first = gas.run("", {"--keep-dumps"});
    const Answer again = gas.run(energy);
    BOOST_TEST(again.says("1 runs measured again from kept frames"), again.err);
    auto after = values_of(again);
    for (const auto& [name, value] : values_of(first))
        BOOST_TEST(after.at(name) == value, name);
    BOOST_TEST((values_of(gas.run(energy, {"--fresh"})) == after));
}
