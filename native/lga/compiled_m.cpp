// Reading M as code.
#include "native/lga/instruction_sets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "native/lga/compiled_m.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "native/lga/compiled_collision-inl.hpp"

// Once, not for every target.
#ifndef CROSSGRAIN_LGA_PLAN_M
#define CROSSGRAIN_LGA_PLAN_M
namespace crossgrain::lga {

inline constexpr auto plan_m = compiled_rows::compiled([] {
    return compiled_rows::plan_of(compiled_rows::with_spectators(), Relocation::random_walk);
});

}  // namespace crossgrain::lga
#endif

HWY_BEFORE_NAMESPACE();
namespace crossgrain::lga::HWY_NAMESPACE {

template <std::size_t lanes>
std::unique_ptr<ColumnKernel<lanes>> compiled_m(const Model& model, const CollisionPlan& actual,
                                                const SourceOf<lanes>& source) {
    return kernel_if_matching<lanes, plan_m>(model, actual, source);
}

#if HWY_MAX_BYTES >= 32
template CompiledKernel<4> compiled_m<4>;
#endif
#if HWY_MAX_BYTES >= 64
template CompiledKernel<8> compiled_m<8>;
#endif

}  // namespace crossgrain::lga::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
