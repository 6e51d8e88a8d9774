// From the run-time choice of a law and its conventions to the compile-time one, once per run.
#pragma once

#include "native/friction/system.hpp"

namespace crossgrain::friction {

namespace law_choice {

template <Conventions so_far, class Use>
auto with_limit(const Conventions& wanted, const Use& use) {
    constexpr Conventions total{so_far.velocity_lever, so_far.torque_lever, so_far.rotation,
                                CoulombLimit::total};
    constexpr Conventions spring_only{so_far.velocity_lever, so_far.torque_lever, so_far.rotation,
                                      CoulombLimit::spring_only};
    return wanted.limit == CoulombLimit::total
               ? use.template operator()<TangentialForce::spring, total>()
               : use.template operator()<TangentialForce::spring, spring_only>();
}

template <Conventions so_far, SpringRotation rotation>
constexpr Conventions turning{so_far.velocity_lever, so_far.torque_lever, rotation, so_far.limit};

/// Rotation and limit are a spring's: without one there is nothing to choose.
template <Conventions so_far, class Use>
auto with_force(TangentialForce force, const Conventions& wanted, const Use& use) {
    if (force == TangentialForce::dashpot) {
        return use.template operator()<TangentialForce::dashpot, so_far>();
    }
    switch (wanted.rotation) {
    case SpringRotation::project:
        break;
    case SpringRotation::project_and_rescale:
        return with_limit<turning<so_far, SpringRotation::project_and_rescale>>(wanted, use);
    case SpringRotation::rotate:
        return with_limit<turning<so_far, SpringRotation::rotate>>(wanted, use);
    }
    return with_limit<turning<so_far, SpringRotation::project>>(wanted, use);
}

template <Lever velocity_lever, class Use>
auto with_torque_lever(TangentialForce force, const Conventions& wanted, const Use& use) {
    return wanted.torque_lever == Lever::radius
               ? with_force<Conventions{velocity_lever, Lever::radius}>(force, wanted, use)
               : with_force<Conventions{velocity_lever, Lever::contact_point}>(force, wanted, use);
}

}  // namespace law_choice

/// Calls use.operator()<TangentialForce, Conventions>() with the ones of the contact.
template <class Use>
auto with_law_of(const ContactParameters& contact, const Use& use) {
    const auto force = contact.tangential;
    const auto& wanted = contact.conventions;
    if (force == TangentialForce::none) {
        return use.template operator()<TangentialForce::none, Conventions{}>();
    }
    return wanted.velocity_lever == Lever::radius
               ? law_choice::with_torque_lever<Lever::radius>(force, wanted, use)
               : law_choice::with_torque_lever<Lever::contact_point>(force, wanted, use);
}

}  // namespace crossgrain::friction
