// No text from outside gets into the input of a foreign code, and grains far apart are run or
// refused with the reason.
#include "adapters/lammps/lammps_code.hpp"
#include "adapters/liggghts/liggghts_code.hpp"
#include "adapters/yade/yade_code.hpp"
#include "tests/support/scenes.hpp"

#include <boost/test/unit_test.hpp>

#include <memory>
#include <string>
#include <vector>

using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

std::vector<std::unique_ptr<adapters::GrainCode>> foreign_codes() {
    std::vector<std::unique_ptr<adapters::GrainCode>> codes;
    codes.push_back(std::make_unique<adapters::LammpsCode>());
    codes.push_back(std::make_unique<adapters::LiggghtsCode>());
    codes.push_back(std::make_unique<adapters::YadeCode>());
    return codes;
}

std::string whole_input(const adapters::GrainCode& code, const scene::Scene& scene) {
    std::string text;
    for (const auto& file : code.input(scene))
        text += file.name + ":\n" + file.text;
    return text;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_name_leaves_no_trace_in_any_input) {
    for (const auto& code : foreign_codes()) {
        for (auto scene : {head_on_pair(), small_bed(), small_gas(), free_lid_collision()}) {
            scene.name = "plain";
            const std::string plain = whole_input(*code, scene);
            BOOST_TEST(plain.find("plain") == std::string::npos, code->name());
            for (const auto* hostile :
                 {"x\nshell touch pwned\n#", "\"\"\"\nimport os", "&\n", ""}) {
                scene.name = hostile;
                BOOST_TEST(whole_input(*code, scene) == plain, code->name());
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(many_grains_far_apart_are_not_expressible_by_bins) {
    auto scene = head_on_pair();
    const auto codes = foreign_codes();
    add_grain(scene, 1e7, 1e7, 0, 0);
    for (const auto& code : codes)
        BOOST_TEST(!code->cannot_express(scene).has_value(), code->name());
    for (const std::size_t family : {0, 1}) {
        BOOST_TEST(whole_input(*codes[family], scene).find("atom_modify sort 0") !=
                   std::string::npos);
        BOOST_TEST(whole_input(*codes[family], head_on_pair()).find("atom_modify") ==
                   std::string::npos);
    }
    for (int i = 0; i < 100; ++i)
        add_grain(scene, 100.0 * i, 1000, 0, 0);
    for (const auto& code : {std::cref(*codes[0]), std::cref(*codes[1])}) {
        const auto reason = code.get().cannot_express(scene);
        BOOST_TEST_REQUIRE(reason.has_value());
        BOOST_TEST(reason->find("bins") != std::string::npos);
    }
    BOOST_TEST(!codes[2]->cannot_express(scene).has_value());
}
