// A program is what it computes with, not what it says it is: a rebuilt LAMMPS under its old
// version is another program, and its runs are its own.
#include "adapters/lammps/lammps_code.hpp"
#include "tests/app/program.hpp"
#include "tests/support/external_code.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace fs = std::filesystem;
using crossgrain::tests::Answer;
using crossgrain::tests::Program;
using nlohmann::json;

using NeedsLammps = crossgrain::tests::NeedsCode<crossgrain::adapters::LammpsCode>;
BOOST_TEST_GLOBAL_FIXTURE(NeedsLammps);

namespace {

/// `lmp` in a directory of its own, which goes first on PATH: the real one behind a script that
/// changes a parameter of every input by a sed expression ("" for none).
void put_wrapper(Program& crossgrain, const std::string& edit) {
    const fs::path directory = crossgrain.directory() / "bin";
    fs::create_directories(directory);
    std::ofstream script(directory / "lmp");
    script << "#!/bin/sh\n";
    if (!edit.empty()) {
        script << "if [ -f in.lammps ]; then sed -i -E '" << edit << "' in.lammps; fi\n";
    }
    script << "PATH=\"" << std::getenv("PATH") << "\" exec lmp \"$@\"\n";
    script.close();
    fs::permissions(directory / "lmp", fs::perms::owner_all);
    crossgrain.environment = {"PATH=" + directory.string() + ":" + std::getenv("PATH")};
}

json run_of(const Answer& answer) {
    const json document = json::parse(answer.out);
    return document["cases"][0]["runs"][0];
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_changed_program_under_its_old_version_is_another_one) {
    Program crossgrain;
    const auto file = crossgrain.case_with("small-gas", "name = ", "name = ");
    const std::vector<std::string> command{"run", file, "--code", "lammps", "--json"};
    put_wrapper(crossgrain, "");
    const Answer honest = crossgrain(command);
    BOOST_TEST(honest.says("1 runs computed"), honest.err);
    BOOST_TEST(crossgrain(command).says("0 runs computed, 1 taken"));

    put_wrapper(crossgrain, "s/^(pair_coeff . . hooke) [0-9.]+/\\1 250.0/");
    const Answer changed = crossgrain(command);
    BOOST_TEST(changed.says("1 runs computed"), changed.err);
    BOOST_TEST(changed.says("is not the program that ran before"), changed.err);
    BOOST_TEST(run_of(changed)["version"] == run_of(honest)["version"]);
    BOOST_TEST(run_of(changed)["digest"] != run_of(honest)["digest"]);
    BOOST_TEST(run_of(changed)["digest"].get<std::string>().size() == 64u);
    const auto measurements = [](const Answer& answer) {
        return json::parse(answer.out)["cases"][0]["measurements"];
    };
    BOOST_TEST(measurements(changed) != measurements(honest));

    // The healthy one is found again, and nothing was stored under its key.
    put_wrapper(crossgrain, "");
    const Answer again = crossgrain(command);
    BOOST_TEST(again.says("0 runs computed, 1 taken"), again.err);
    BOOST_TEST(measurements(again) == measurements(honest));
}
