// Which kernel computes a system, and what no kernel takes.
#include "native/friction/kernel.hpp"
#include "native/friction/simd_step.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace crossgrain::friction {
namespace {

/// From here on vectors win. Smaller systems are those of certificates, which rest on the rounding
/// of the scalar kernel.
constexpr std::size_t grains_worth_simd = 256;

void require(bool right, const char* what, double value, const char* expected) {
    if (!right)
        throw std::invalid_argument(fmt::format("{} is {:g}, expected {}", what, value, expected));
}

void check(const Parameters& p, const State& s) {
    const auto& c = p.contact;
    require(p.dt > 0, "dt", p.dt, "> 0");
    require(c.stiffness > 0, "the contact stiffness", c.stiffness, "> 0");
    require(c.damping >= 0, "the contact damping", c.damping, ">= 0");
    require(c.friction >= 0, "the friction coefficient", c.friction, ">= 0");
    require(c.tangential_damping >= 0, "the tangential damping", c.tangential_damping, ">= 0");
    require(c.tangential != TangentialForce::spring || c.tangential_stiffness > 0,
            "the tangential stiffness", c.tangential_stiffness, "> 0 with a spring");
    require(p.inertia_factor > 0, "the inertia factor", p.inertia_factor, "> 0");
    const std::size_t n = s.x.size();
    for (const auto* values : {&s.y, &s.vx, &s.vy, &s.omega, &s.radius, &s.mass}) {
        require(values->size() == n, "the length of an array of the state",
                static_cast<double>(values->size()), "the number of grains");
    }
    for (std::size_t i = 0; i < n; ++i) {
        require(s.radius[i] > 0, "a radius", s.radius[i], "> 0");
        require(s.mass[i] > 0, "a mass", s.mass[i], "> 0");
    }
    for (const std::size_t i : s.frozen)
        require(i < n, "the index of a frozen grain", static_cast<double>(i), "a grain's");
}

State with_frozen_at_rest(State s) {
    for (const std::size_t i : s.frozen)
        s.vx[i] = s.vy[i] = s.omega[i] = 0;
    return s;
}

}  // namespace

std::unique_ptr<StepKernel> make_kernel(const Parameters& p, State s) {
    check(p, s);
    s = with_frozen_at_rest(std::move(s));
    const bool possible = simd_lanes() > 0;
    if (p.kernel == Kernel::simd && !possible) {
        throw std::invalid_argument("this processor has no vectors that serve");
    }
    const bool suits = possible && s.x.size() - s.frozen.size() >= grains_worth_simd;
    const bool simd = p.kernel == Kernel::simd || (p.kernel == Kernel::automatic && suits);
    return simd ? make_simd_kernel(p, std::move(s)) : make_scalar_kernel(p, std::move(s));
}

}  // namespace crossgrain::friction
