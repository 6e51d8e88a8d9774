// Which kernel computes a system.
#include "native/dem/kernel.hpp"
#include "native/dem/simd_step.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace crossgrain::dem {
namespace {

/// From here on vectors win over the time that their lists take.
constexpr std::size_t grains_worth_simd = 256;

}  // namespace

std::optional<std::string> why_not_simd(const Parameters& p, const State& s) {
    if (p.scheme != Scheme::verlet_half_step && p.scheme != Scheme::verlet_predicted) {
        return "the simd kernel has velocity Verlet only";
    }
    if (p.contacts != Contacts::neighbour_list) return "the simd kernel has no fixed neighbours";
    if (!s.frozen.empty()) return "the simd kernel has no frozen grains";
    if (p.period_y) return "the simd kernel has no period along y";
    if (p.period_x && *p.period_x < 8 * p.diameter) {
        return "the simd kernel needs a period of 8 diameters or more";
    }
    if (s.x.empty()) return "there are no grains";
    if (double_step_functions(p).group.lanes == 0)
        return "this processor has no vectors that serve";
    return std::nullopt;
}

std::unique_ptr<StepKernel> make_kernel(const Parameters& p, State s) {
    if (!(p.dt > 0)) throw std::invalid_argument(fmt::format("dt is {:g}, expected > 0", p.dt));
    const bool mixed = p.precision == Precision::mixed;
    if (p.kernel == Kernel::scalar && mixed) {
        throw std::invalid_argument("mixed precision needs the simd kernel, not the scalar one");
    }
    const auto obstacle = why_not_simd(p, s);
    const bool demanded = p.kernel == Kernel::simd || mixed;
    if (demanded && obstacle) throw std::invalid_argument(*obstacle);
    // Certificates against other codes rest on the rounding of the half-step scheme: it stays on
    // the scalar kernel unless asked otherwise.
    const bool suits =
        s.x.size() >= grains_worth_simd && p.scheme == Scheme::verlet_predicted && !obstacle;
    const bool simd = demanded || (p.kernel == Kernel::automatic && suits);
    return simd ? make_simd_kernel(p, std::move(s)) : make_scalar_kernel(p, std::move(s));
}

}  // namespace crossgrain::dem
