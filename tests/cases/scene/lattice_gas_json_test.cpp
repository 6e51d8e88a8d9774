// The identity of a run holds every number that decides it, and nothing that does not.
#include "cases/scene/any_scene.hpp"
#include "cases/scene/model_json.hpp"
#include "tests/cases/scene/gas_text.hpp"

#include <nlohmann/json.hpp>

#include <boost/test/unit_test.hpp>

#include <string>

using namespace crossgrain;

namespace {

std::string identity(const std::string& text, std::uint64_t seed = 1) {
    return scene::to_json(tests::read_gas(text, seed)).dump();
}

std::string signal_identity(const std::string& text) {
    return scene::to_json(tests::read_signal(text)).dump();
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_number_of_a_gas_changes_its_identity) {
    const std::string before = identity(tests::gas_text);
    BOOST_TEST(before == identity(tests::gas_text));
    BOOST_TEST(before != identity(tests::gas_text, 2));
    const auto changes = [&](const std::string& what, const std::string& by) {
        BOOST_TEST(before != identity(tests::replaced(tests::gas_text, what, by)), what);
    };
    changes("\"P\"", "\"D\"");
    changes("length = 220", "length = 240");
    changes("width = 11", "width = 12");
    changes("density = 1.0", "density = 1.1");
    changes("\"periodic\"\ndensity = 1.0", "\"open\"\ninjection = 1.0");
    changes("dissipation = 0.8", "dissipation = 0.7");
    changes("gravity = 0.5", "gravity = 0.4");
    changes("roughness = 0.25", "roughness = 0.3");
    changes("bin = 10", "bin = 5");
    changes("replicas = 64", "replicas = 65");
    changes("burn_in = 100", "burn_in = 0");
    changes("steps = 1000", "steps = 1010");
    changes("every = 10", "every = 5");
    changes("every = 10", "every = 10, fields = [\"count\", \"rests\"]");
    changes("roughness = 0.25", "roughness = 0.25\nengine = \"table\"");
    changes("roughness = 0.25", "roughness = 0.25\non_saturation = \"record\"");
}

BOOST_AUTO_TEST_CASE(names_of_readings_do_not_count_their_rules_do) {
    const auto with = [](const std::string& rows) {
        const tests::TextFile file(tests::reading_with(rows));
        auto gas =
            tests::read_gas(tests::replaced(tests::gas_text, "\"P\"", "\"" + file.path() + "\""));
        gas.reading.name = "any";
        return scene::to_json(gas).dump();
    };
    const std::string before = with("{ from = \"i i+3\", to = \"R R\", probability = \"p\" }");
    // The same rule written out in another way.
    BOOST_TEST(before == with("{ from = \"0 3\", to = \"R R\", probability = \"p\" },\n"
                              "{ from = \"1 4\", to = \"R R\", probability = \"p\" },\n"
                              "{ from = \"2 5\", to = \"R R\", probability = \"p/1\" }"));
    BOOST_TEST(before != with("{ from = \"i i+3\", to = \"R R\", probability = \"1-p\" }"));
    BOOST_TEST(before !=
               with("{ from = \"i i+3\", to = \"R R\", probability = \"p\", spectators = true }"));
}

BOOST_AUTO_TEST_CASE(every_number_of_a_signal_changes_its_identity) {
    const std::string before = signal_identity(tests::signal_text);
    const auto changes = [&](const std::string& what, const std::string& by) {
        BOOST_TEST(before != signal_identity(tests::replaced(tests::signal_text, what, by)), what);
    };
    changes("mean = 1000", "mean = 1001");
    changes("noise = 50", "noise = 51");
    changes("exponent = 1.33", "exponent = 1.34");
    changes("wave_amplitude = 20", "wave_amplitude = 21");
    changes("wave_velocity = 0.36", "wave_velocity = 0.37");
    changes("wave_velocity = 0.36", "wave_velocity = 0.36\nwave_number = 2");
    changes("steps = 1000", "steps = 2000");
}

BOOST_AUTO_TEST_CASE(the_work_of_a_gas_is_its_site_updates) {
    const scene::Work work = scene::work_of(tests::read_gas(tests::gas_text));
    BOOST_TEST(work.amount == 220.0 * 11 * 64 * 1100);
    BOOST_TEST(work.unit == "site-updates");
}
