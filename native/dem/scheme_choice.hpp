// Every scheme that Parameters can ask for; resolved once per call, outside the step loop.
#pragma once

#include "native/dem/scheme_euler.hpp"
#include "native/dem/scheme_leapfrog.hpp"
#include "native/dem/scheme_runge_kutta.hpp"
#include "native/dem/scheme_taguchi.hpp"
#include "native/dem/scheme_verlet.hpp"

#include <variant>

namespace crossgrain::dem {

using AnyScheme =
    std::variant<Verlet<DashpotVelocity::half_step>, Verlet<DashpotVelocity::predicted>,
                 LeapfrogCrankNicolson, SemiImplicitEuler, ExplicitEuler, RungeKutta4, TaguchiEuler,
                 TaguchiAdaptiveEuler>;

[[nodiscard]] inline AnyScheme scheme_of(const Parameters& p) {
    switch (p.scheme) {
    case Scheme::verlet_half_step:
        break;
    case Scheme::verlet_predicted:
        return Verlet<DashpotVelocity::predicted>{};
    case Scheme::leapfrog_crank_nicolson:
        return LeapfrogCrankNicolson{};
    case Scheme::semi_implicit_euler:
        return SemiImplicitEuler{};
    case Scheme::explicit_euler:
        return ExplicitEuler{};
    case Scheme::runge_kutta_4:
        return RungeKutta4{};
    case Scheme::taguchi_euler:
        return TaguchiEuler{};
    case Scheme::taguchi_adaptive_euler:
        return TaguchiAdaptiveEuler{};
    }
    return Verlet<DashpotVelocity::half_step>{};
}

}  // namespace crossgrain::dem
