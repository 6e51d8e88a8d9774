// What a scheme of integration is: it makes one time step of any system that can tell
// accelerations. To add one, write a class like those in scheme_*.hpp and a line in
// scheme_choice.hpp.
#pragma once

#include "native/dem/motion.hpp"

#include <concepts>
#include <vector>

namespace crossgrain::dem {

/// accelerations(q, v, t, a): a(q, v, t) of all degrees of freedom.
template <class System>
concept Accelerated = requires(System& system, const std::vector<double>& q,
                               const std::vector<double>& v, std::vector<double>& a) {
    system.accelerations(q, v, 0.0, a);
};

/// start: called once, before the first step; step: from (q, v) at t.start to (q, v) at t.end.
template <class S, class System>
concept IntegrationScheme = Accelerated<System> && std::default_initializable<S> &&
    requires(S scheme, System& system, Motion& m, const TimeStep& t) {
    scheme.start(system, m, 0.0);
    scheme.step(system, m, t);
};

/// y += h x, element by element.
inline void add_scaled(std::vector<double>& y, double h, const std::vector<double>& x) {
    for (std::size_t i = 0; i < y.size(); ++i)
        y[i] += h * x[i];
}

}  // namespace crossgrain::dem
