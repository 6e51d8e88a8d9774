// Reading D as code.
#include "native/lga/instruction_sets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "native/lga/compiled_d.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "native/lga/compiled_collision-inl.hpp"

// Once, not for every target.
#ifndef CROSSGRAIN_LGA_PLAN_D
#define CROSSGRAIN_LGA_PLAN_D
namespace crossgrain::lga {

inline constexpr auto plan_d = compiled_rows::compiled([] {
    return compiled_rows::plan_of(compiled_rows::with_two_at_120_degrees(),
                                  Relocation::random_walk);
});

}  // namespace crossgrain::lga
#endif

HWY_BEFORE_NAMESPACE();
namespace crossgrain::lga::HWY_NAMESPACE {

template <std::size_t lanes>
std::unique_ptr<ColumnKernel<lanes>> compiled_d(const Model& model, const CollisionPlan& actual,
                                                const SourceOf<lanes>& source) {
    return kernel_if_matching<lanes, plan_d>(model, actual, source);
}

#if HWY_MAX_BYTES >= 32
template CompiledKernel<4> compiled_d<4>;
#endif
#if HWY_MAX_BYTES >= 64
template CompiledKernel<8> compiled_d<8>;
#endif

}  // namespace crossgrain::lga::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
