#include "native/base/instruction_sets.hpp"

#include <hwy/targets.h>

namespace crossgrain {
namespace {

/// Highway numbers better targets of a processor lower: all from AVX2 on.
constexpr auto better_than_avx2 = HWY_AVX2 - 1;

void choose_again() {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace

bool has_avx512() {
    return (hwy::SupportedTargets() & better_than_avx2) != 0;
}

WithoutAvx512::WithoutAvx512() {
    hwy::SetSupportedTargetsForTest(hwy::SupportedTargets() & ~better_than_avx2);
    choose_again();
}

WithoutAvx512::~WithoutAvx512() {
    hwy::SetSupportedTargetsForTest(0);
    choose_again();
}

}  // namespace crossgrain
