// Reading std as code.
#include "native/lga/instruction_sets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "native/lga/compiled_std.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "native/lga/compiled_collision-inl.hpp"

// Once, not for every target.
#ifndef CROSSGRAIN_LGA_PLAN_STD
#define CROSSGRAIN_LGA_PLAN_STD
namespace crossgrain::lga {

inline constexpr auto plan_std = compiled_rows::compiled([] {
    return compiled_rows::plan_of(compiled_rows::head_on_and_triples(), Relocation::random_walk);
});

}  // namespace crossgrain::lga
#endif

HWY_BEFORE_NAMESPACE();
namespace crossgrain::lga::HWY_NAMESPACE {

template <std::size_t lanes>
std::unique_ptr<ColumnKernel<lanes>> compiled_std(const Model& model, const CollisionPlan& actual,
                                                  const SourceOf<lanes>& source) {
    return kernel_if_matching<lanes, plan_std>(model, actual, source);
}

#if HWY_MAX_BYTES >= 32
template CompiledKernel<4> compiled_std<4>;
#endif
#if HWY_MAX_BYTES >= 64
template CompiledKernel<8> compiled_std<8>;
#endif

}  // namespace crossgrain::lga::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
