// Every contact law that Parameters can ask for; resolved once per call, outside the step loop.
#pragma once

#include "native/dem/contact_law.hpp"

#include <variant>

namespace crossgrain::dem {

using Law =
    std::variant<SpringDashpot<DampingDirection::full_vector, AttractiveTail::kept>,
                 SpringDashpot<DampingDirection::full_vector, AttractiveTail::contact_force_cut>,
                 SpringDashpot<DampingDirection::full_vector, AttractiveTail::normal_force_cut>,
                 SpringDashpot<DampingDirection::normal_only, AttractiveTail::kept>,
                 SpringDashpot<DampingDirection::normal_only, AttractiveTail::contact_force_cut>,
                 SpringDashpot<DampingDirection::normal_only, AttractiveTail::normal_force_cut>>;

template <DampingDirection damping>
[[nodiscard]] Law law_with(const Parameters& p) {
    switch (p.tail) {
    case AttractiveTail::kept:
        break;
    case AttractiveTail::contact_force_cut:
        return SpringDashpot<damping, AttractiveTail::contact_force_cut>{p.stiffness, p.damping};
    case AttractiveTail::normal_force_cut:
        return SpringDashpot<damping, AttractiveTail::normal_force_cut>{p.stiffness, p.damping};
    }
    return SpringDashpot<damping, AttractiveTail::kept>{p.stiffness, p.damping};
}

[[nodiscard]] inline Law law_of(const Parameters& p) {
    return p.damping_direction == DampingDirection::full_vector
               ? law_with<DampingDirection::full_vector>(p)
               : law_with<DampingDirection::normal_only>(p);
}

}  // namespace crossgrain::dem
