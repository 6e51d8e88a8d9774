// The same bits on every processor: each instruction set that this one can show, down to plain C++,
// against one of the table engine's trajectories.
#include "tests/native/lga/ensembles.hpp"
#include "tests/native/lga/readings.hpp"

#include <hwy/detect_targets.h>
#include <hwy/targets.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

using namespace crossgrain;

namespace {

/// Pretends, while it lives, that the processor has one instruction set only.
class Pretended {
  public:
    explicit Pretended(std::int64_t target) { hwy::SetSupportedTargetsForTest(target); }
    ~Pretended() { hwy::SetSupportedTargetsForTest(0); }
    Pretended(const Pretended&) = delete;
    Pretended& operator=(const Pretended&) = delete;
};

struct InstructionSet {
    std::int64_t target;
    int widest_word;
};

/// The one that is compiled in, SSE2 unless the compiler was told more (presets with sanitizers).
constexpr InstructionSet baseline{HWY_STATIC_TARGET, HWY_STATIC_TARGET <= HWY_AVX3_DL ? 512
                                                     : HWY_STATIC_TARGET <= HWY_AVX2  ? 256
                                                                                      : 64};

std::vector<InstructionSet> instruction_sets() {
    std::vector<InstructionSet> all{baseline};
    const auto has = hwy::SupportedTargets();
    if ((has & HWY_AVX2) != 0) all.push_back({HWY_AVX2, 256});
    if ((has & HWY_AVX3_DL) != 0) all.push_back({HWY_AVX3_DL, 512});
    return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_instruction_set_has_the_words_it_should_have) {
    for (const auto& set : instruction_sets()) {
        const Pretended pretended(set.target);
        BOOST_TEST(lga::word_widths().back() == set.widest_word);
    }
}

BOOST_AUTO_TEST_CASE(all_instruction_sets_give_the_same_trajectories) {
    for (const auto& name : tests::readings) {
        for (const bool periodic : {true, false}) {
            auto model = tests::reading(name, 0.3);
            model.replicas = 130;
            model.periodic = periodic;
            model.injection = 0.4;
            const auto table = lga::make_table_ensemble(model);
            table->advance(40);
            for (const auto& set : instruction_sets()) {
                const Pretended pretended(set.target);
                for (const int bits : lga::word_widths()) {
                    const auto sliced = lga::make_sliced_ensemble(model, bits);
                    sliced->advance(40);
                    BOOST_TEST(tests::first_difference(*sliced, *table, model) == -1,
                               name << ", " << hwy::TargetName(set.target) << ", " << bits
                                    << " bits");
                }
            }
        }
    }
}

// Code made ahead and the interpreter: p = 0 and 1 and a changed table leave the compiled plans.
BOOST_AUTO_TEST_CASE(tables_without_code_of_their_own_are_interpreted_with_the_same_bits) {
    auto model = tests::reading("P", 0.3);
    for (int i = 0; i < 6; ++i) {
        model.rules.push_back(
            {tests::at(i, {0}, 1), tests::at(i, {-1, 1}), 0.1, lga::Matching::exact, "splits R"});
    }
    const auto table = lga::make_table_ensemble(model);
    table->advance(60);
    for (const int bits : lga::word_widths()) {
        const auto sliced = lga::make_sliced_ensemble(model, bits);
        sliced->advance(60);
        BOOST_TEST(tests::first_difference(*sliced, *table, model) == -1);
    }
}
