// A run of the lattice gas is what its table says, and every bad number is one clear line.
#include "cases/scene/gas_sampling.hpp"
#include "tests/cases/scene/gas_text.hpp"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace crossgrain;
using tests::check_refusal;

namespace {

CaseErrorDetails gas_refusal(const std::string& what, const std::string& by) {
    return tests::refusal(
        [&] { (void)tests::read_gas(tests::replaced(tests::gas_text, what, by)); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_table_becomes_the_run) {
    const auto gas = tests::read_gas(tests::gas_text, 7);
    BOOST_TEST(gas.reading.name == "P");
    BOOST_TEST(gas.sampling.length == 220);
    BOOST_TEST(gas.sampling.width == 11);
    BOOST_TEST(gas.sampling.bins() == 22);
    BOOST_TEST(gas.sampling.frames() == 101);
    BOOST_TEST(gas.sampling.replicas == 64);
    BOOST_TEST(gas.sampling.burn_in == 100);
    BOOST_TEST(gas.sampling.periodic);
    BOOST_TEST(gas.density == 1.0);
    BOOST_TEST(gas.dissipation == 0.8);
    BOOST_TEST(gas.gravity == 0.5);
    BOOST_TEST(gas.roughness == 0.25);
    BOOST_TEST(gas.seed == 7U);
    BOOST_TEST((gas.engine == scene::GasEngine::bit_sliced));
    BOOST_TEST((gas.on_saturation == scene::OnSaturation::fail));
    BOOST_TEST(gas.sampling.fields.count);
    BOOST_TEST(!gas.sampling.fields.rests);
}

BOOST_AUTO_TEST_CASE(an_open_pipe_is_fed_instead_of_filled) {
    const auto open = tests::replaced(tests::gas_text, "\"periodic\"\ndensity = 1.0",
                                      "\"open\"\ninjection = 0.5");
    const auto gas = tests::read_gas(open);
    BOOST_TEST(!gas.sampling.periodic);
    BOOST_TEST(gas.injection == 0.5);
    check_refusal(gas_refusal("\"periodic\"", "\"open\"\ninjection = 0.5"), "density", 6,
                  "contradicts");
    check_refusal(gas_refusal("density = 1.0", "density = 1.0\ninjection = 0.5"), "injection", 6,
                  "contradicts");
    BOOST_TEST(gas_refusal("\"periodic\"\ndensity = 1.0", "\"open\"").key == "scene.injection");
}

BOOST_AUTO_TEST_CASE(a_number_out_of_range_is_refused) {
    const auto check = [](const std::string& what, const std::string& by, const std::string& key,
                          int line) {
        check_refusal(gas_refusal(what, by), key, line, "is out of range");
    };
    check("density = 1.0", "density = 0.0", "density", 5);
    check("density = 1.0", "density = 7.1", "density", 5);
    check("dissipation = 0.8", "dissipation = 1.01", "dissipation", 6);
    check("dissipation = 0.8", "dissipation = -0.1", "dissipation", 6);
    check("gravity = 0.5", "gravity = 2", "gravity", 7);
    check("roughness = 0.25", "roughness = -1", "roughness", 8);
    check("\"periodic\"\ndensity = 1.0", "\"open\"\ninjection = 1.2", "injection", 5);
    check("width = 11", "width = 2", "width", 3);
    check("length = 220", "length = 0", "length", 2);
    check("replicas = 64", "replicas = 513", "sample.replicas", 9);
    check("replicas = 64", "replicas = 0", "sample.replicas", 9);
    check("steps = 1000", "steps = 0", "sample.steps", 9);
    check("every = 10", "every = 0", "sample.every", 9);
    check("burn_in = 100", "burn_in = -1", "sample.burn_in", 9);
    BOOST_TEST(tests::read_gas(tests::replaced(tests::gas_text, "density = 1.0", "density = 7.0"))
                   .density == 7.0);
}

BOOST_AUTO_TEST_CASE(more_than_the_pipe_can_hold_is_refused) {
    // Reading M counts the walls inside the width: 9 columns of 7, and 2 + 2 at the walls, of 11.
    const auto dense = [](const char* density) {
        return tests::replaced(
            tests::replaced(tests::gas_text, "density = 1.0", std::string("density = ") + density),
            "reading = \"P\"", "reading = \"M\"");
    };
    check_refusal(tests::refusal([&] { (void)tests::read_gas(dense("6.1")); }), "density", 5,
                  "is more than the pipe can hold");
    BOOST_TEST(tests::read_gas(dense("6.09")).density == 6.09);
}

BOOST_AUTO_TEST_CASE(what_does_not_divide_is_refused) {
    check_refusal(gas_refusal("length = 220", "length = 225"), "length", 2,
                  "is not a multiple of the bin");
    check_refusal(gas_refusal("steps = 1000", "steps = 1005"), "sample.steps", 9,
                  "is not a multiple of 'every'");
}

BOOST_AUTO_TEST_CASE(a_bin_that_a_frame_cannot_count_is_refused) {
    const auto e = tests::refusal([] {
        auto text = tests::replaced(tests::gas_text, "length = 220", "length = 10000");
        text = tests::replaced(text, "bin = 10", "bin = 10000");
        (void)tests::read_gas(text);
    });
    check_refusal(e, "sample.bin", 9, "is too large");
    BOOST_TEST(e.expected == "at most 630 sites for this width");
}

BOOST_AUTO_TEST_CASE(unknown_words_and_keys_are_refused_with_the_nearest) {
    BOOST_TEST(gas_refusal("\"periodic\"", "\"peridic\"").hint == "did you mean \"periodic\"?");
    BOOST_TEST(gas_refusal("gravity = 0.5", "gravty = 0.5").hint == "did you mean 'gravity'?");
    BOOST_TEST(gas_refusal("every = 10", "every = 10, evry = 2").key == "scene.sample.evry");
    check_refusal(gas_refusal("every = 10", "every = 10, fields = [\"count\", \"rest\"]"),
                  "sample.fields", 9, "names what is not known");
    check_refusal(gas_refusal("roughness = 0.25", "roughness = 0.25\nengine = \"fast\""), "engine",
                  9, "is not known");
}

BOOST_AUTO_TEST_CASE(a_reading_is_a_shipped_name_or_a_file_beside_the_case) {
    const auto e = gas_refusal("\"P\"", "\"Q\"");
    check_refusal(e, "reading", 1, "is not known");
    BOOST_TEST(e.expected.find("\"D\", \"M\", \"P\", \"std\"") != std::string::npos);
    check_refusal(gas_refusal("\"P\"", "\"mine.toml\""), "reading", 1, "cannot be read");
    check_refusal(gas_refusal("\"P\"", "\"./P\""), "reading", 1, "cannot be read");
    const tests::TextFile file(tests::reading_with("{ from = \"i i+3\", to = \"R R\" }"));
    const auto gas =
        tests::read_gas(tests::replaced(tests::gas_text, "\"P\"", "\"" + file.path() + "\""));
    BOOST_TEST(gas.reading.rows.size() == 3U);
    BOOST_TEST(gas.reading.file == file.path());
}

BOOST_AUTO_TEST_CASE(a_broken_row_of_the_users_own_reading_names_that_file) {
    const tests::TextFile file(tests::reading_with("{ from = \"i i+3\", to = \"R\" }"));
    const auto e = gas_refusal("\"P\"", "\"" + file.path() + "\"");
    BOOST_TEST(e.file == file.path());
    BOOST_TEST(e.line == 4);
}
