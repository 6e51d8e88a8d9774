// The command line with the models on lattices: the same bits with any number of threads, bad input
// in one line, maps of states.
#include "tests/app/program.hpp"

#include <boost/test/unit_test.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

using crossgrain::tests::Answer;
using crossgrain::tests::Program;
using nlohmann::json;

namespace {

const std::string gas = R"(name = "pipe"
title = "A short pipe"
source = "test"
text = "Two densities."
model = "lattice-gas"
suites = ["quick"]
time_limit = 60.0
[scene]
reading = "P"
length = 40
width = 5
ends = "periodic"
density = 1.0
dissipation = 0.5
gravity = 0.5
roughness = 0.5
sample = { bin = 10, replicas = 16, steps = 600, every = 10, fields = ["count", "rests", "momentum"] }
[sweep]
density = [0.5, 1.0]
[[observable]]
name = "gas-flux"
[[observable]]
name = "gas-steady-state"
)";

const std::string hopper = R"(name = "hopper"
title = "A small hopper"
source = "test"
text = "One angle."
model = "hopper-automaton"
suites = ["quick"]
time_limit = 60.0
[scene]
outlet = 5
levels = 60
angles = [40.0]
c_d = 0.01
c_o = 0.0
c_i = 0.1
c_w = 0.1
iterations = 20
replicas = 4
[[observable]]
name = "hopper-flow"
)";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const auto at = text.find(what);
    BOOST_TEST_REQUIRE(at != std::string::npos, what);
    return text.replace(at, what.size(), by);
}

std::string file_with(const Program& program, const std::string& text) {
    const auto file = (program.directory() / "case.toml").string();
    std::ofstream(file) << text;
    return file;
}

/// One line on stderr that names the key, exit code 2.
void check_refused(const std::string& text, const std::string& what, const std::string& by,
                   const std::string& key) {
    const Program crossgrain;
    const Answer answer =
        crossgrain({"run", file_with(crossgrain, replaced(text, what, by)), "--quiet"});
    BOOST_TEST(answer.status == 2, by);
    BOOST_TEST(answer.says(key), by << " should name " << key << ": " << answer.err);
    BOOST_TEST(std::count(answer.err.begin(), answer.err.end(), '\n') == 1, answer.err);
}

}  // namespace

BOOST_AUTO_TEST_CASE(numbers_do_not_depend_on_threads_or_on_the_run) {
    const auto measured = [](const char* jobs) {
        const Program crossgrain;
        const Answer answer =
            crossgrain({"run", file_with(crossgrain, gas), "--json", "--jobs", jobs});
        BOOST_TEST_REQUIRE(answer.status == 0, answer.err);
        return json::parse(answer.out)["cases"][0]["measurements"];
    };
    const json one = measured("1");
    BOOST_TEST(!one.empty());
    BOOST_TEST(one == measured("2"));
    BOOST_TEST(one == measured("1"));
}

BOOST_AUTO_TEST_CASE(a_code_of_another_model_is_refused) {
    const Program crossgrain;
    const Answer answer = crossgrain({"run", file_with(crossgrain, gas), "--code", "lammps"});
    BOOST_TEST(answer.status == 2);
    BOOST_TEST(answer.says("names no code that runs a lattice-gas"));
}

BOOST_AUTO_TEST_CASE(bad_input_of_a_lattice_gas_is_one_line) {
    check_refused(gas, "dissipation = 0.5", "dissipation = 1.5", "scene.dissipation");
    check_refused(gas, "gravity = 0.5", "gravity = -0.1", "scene.gravity");
    check_refused(gas, "roughness = 0.5", "roughness = 2", "scene.roughness");
    check_refused(gas, "width = 5", "width = 2", "scene.width");
    check_refused(gas, "[0.5, 1.0]", "[0.5, 7.5]", "scene.density");
    check_refused(gas, "bin = 10", "bin = 7", "bin");
    check_refused(gas, "reading = \"P\"", "reading = \"Q\"", "scene.reading");
    check_refused(gas, "name = \"gas-flux\"",
                  "name = \"gas-spectrum\"\nsegments = 4\npoints = 16384", "gas-spectrum");
}

BOOST_AUTO_TEST_CASE(bad_input_of_a_hopper_is_one_line) {
    check_refused(hopper, "outlet = 5", "outlet = 1", "scene.outlet");
    check_refused(hopper, "levels = 60", "levels = 0", "scene.levels");
    check_refused(hopper, "angles = [40.0]", "angles = [180.0]", "scene.angles");
    check_refused(hopper, "c_d = 0.01", "c_d = -0.01", "scene.c_d");
    check_refused(hopper, "c_d = 0.01", "tie_tolerance = 100.0\nc_d = 0.01", "tie_tolerance");
}

BOOST_AUTO_TEST_CASE(a_hopper_with_flat_walls_runs_with_a_warning) {
    const Program crossgrain;
    const Answer answer = crossgrain(
        {"run", file_with(crossgrain, replaced(hopper, "angles = [40.0]", "angles = [130.0]"))});
    BOOST_TEST(answer.status == 0);
    BOOST_TEST(answer.says("warning: hopper: theta = 130 degrees"));
}

BOOST_AUTO_TEST_CASE(the_states_of_a_sweep_are_mapped) {
    const Program crossgrain;
    const Answer answer = crossgrain({"stability", file_with(crossgrain, gas), "--json"});
    BOOST_TEST_REQUIRE(answer.status == 0, answer.err);
    const json points = json::parse(answer.out)["stability"][0]["points"];
    BOOST_TEST_REQUIRE(points.size() == 2U);
    BOOST_TEST(points[0]["at"]["density"] == 0.5);
    BOOST_TEST(!points[0]["state"].get<std::string>().empty());
}

BOOST_AUTO_TEST_CASE(an_unknown_bench_gets_the_nearest_name) {
    const Program crossgrain;
    const Answer answer = crossgrain({"bench", "lgaa"});
    BOOST_TEST(answer.status == 2);
    BOOST_TEST(answer.says("did you mean 'lga'?"));
}
