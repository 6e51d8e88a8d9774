// The loops of simd_contacts-inl.hpp and simd_motion-inl.hpp, compiled for every instruction set.
#include "native/friction/simd_step.hpp"

#include "native/friction/law_choice.hpp"

#include <cstddef>

// Vectors of two doubles are not worth it: the scalar kernel does there.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "native/friction/simd_step.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, and in this order.
#include <hwy/highway.h>

#include "native/friction/simd_contacts-inl.hpp"
#include "native/friction/simd_motion-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace crossgrain::friction {
namespace HWY_NAMESPACE {

#if HWY_ARCH_X86 && HWY_MAX_BYTES >= 32

StepFunctions Functions(const ContactParameters& contact) {
    using AddForces = void (*)(const ForceTask&);
    return {.lanes = hn::Lanes(D()),
            .instruction_set = hwy::TargetName(HWY_TARGET),
            .add_contact_forces =
                with_law_of(contact,
                            []<TangentialForce tangential, Conventions conventions>() -> AddForces {
                                return AddContactForces<tangential, conventions>;
                            }),
            .open = Move<Phase::open>,
            .full = Move<Phase::full>,
            .close = Move<Phase::close>};
}

#else

/// Too narrow, or of a length not known here: lanes = 0 says so.
StepFunctions Functions(const ContactParameters&) {
    return {};
}

#endif  // HWY_ARCH_X86 && HWY_MAX_BYTES >= 32

}  // namespace HWY_NAMESPACE
}  // namespace crossgrain::friction
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace crossgrain::friction {

HWY_EXPORT(Functions);

StepFunctions step_functions(const ContactParameters& contact) {
    return HWY_DYNAMIC_DISPATCH(Functions)(contact);
}

std::size_t simd_lanes() {
    return step_functions({}).lanes;
}

}  // namespace crossgrain::friction
#endif
