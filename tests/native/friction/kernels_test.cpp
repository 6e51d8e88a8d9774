// The simd kernel is the scalar one to round-off, for every law; both give the same bits however a
// run is cut, and springs survive neighbour lists and the sorting of grains. Where a machine has no
// vectors that serve, there is only the scalar one.
#include "native/friction/simd_step.hpp"
#include "tests/native/friction/systems.hpp"

#include <boost/test/unit_test.hpp>
#include <hwy/targets.h>

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

// A collision makes 10 to 30 of an error; there are a few per grain in these runs.
constexpr double grown_round_off = 1e-9;

friction::Parameters gas_parameters() {
    auto p = frictional_discs(0.8, 0.05, 50);
    p.period_x = p.period_y = 15;
    return p;
}

friction::State with(friction::Parameters p, friction::Kernel kernel, const friction::State& start,
                     std::int64_t steps) {
    p.kernel = kernel;
    return after(p, start, steps);
}

/// Those of this machine.
std::vector<friction::Kernel> kernels() {
    if (friction::simd_lanes() == 0) return {friction::Kernel::scalar};
    return {friction::Kernel::scalar, friction::Kernel::simd};
}

/// Scalar against simd after some contact times; 0 where there is no simd.
double disagreement(const friction::Parameters& p, const friction::State& start,
                    std::int64_t steps = 300) {
    if (friction::simd_lanes() == 0) return 0;
    const auto scalar = with(p, friction::Kernel::scalar, start, steps);
    BOOST_TEST(largest_difference(scalar, start) > 1);
    return largest_difference(scalar, with(p, friction::Kernel::simd, start, steps));
}

}  // namespace

BOOST_AUTO_TEST_CASE(kernels_agree_for_every_convention) {
    auto p = gas_parameters();
    for (const auto& conventions : all_conventions()) {
        for (const double damping : {0.0, 3.0}) {
            p.contact.conventions = conventions;
            p.contact.tangential_damping = damping;
            BOOST_TEST(disagreement(p, hot_gas(10, 10, 1.5)) < grown_round_off);
        }
    }
}

BOOST_AUTO_TEST_CASE(kernels_agree_without_springs_and_with_any_damping) {
    auto p = gas_parameters();
    for (const auto force : {friction::TangentialForce::none, friction::TangentialForce::dashpot,
                             friction::TangentialForce::spring}) {
        for (const auto tail : {friction::AttractiveTail::kept, friction::AttractiveTail::cut}) {
            for (const auto scale :
                 {friction::DampingScale::absolute, friction::DampingScale::effective_mass}) {
                p.contact.tangential = force;
                p.contact.tail = tail;
                p.contact.damping_scale = scale;
                p.contact.tangential_damping = 5;
                BOOST_TEST(disagreement(p, hot_gas(10, 10, 1.5, 7)) < grown_round_off);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(kernels_agree_with_fields_open_ends_and_odd_numbers) {
    for (const std::size_t columns : {1UL, 3UL, 9UL}) {
        auto p = gas_parameters();
        p.period_x = {};
        p.gravity = 5;
        p.drag = 0.3;
        p.backing = friction::BackingPlanes{.stiffness = 500, .left = 0, .right = 14};
        BOOST_TEST(disagreement(p, hot_gas(columns, 7, 1.5, 11)) < grown_round_off);
        p.period_y = {};
        BOOST_TEST(disagreement(p, hot_gas(columns, 7, 1.5)) < grown_round_off);
    }
}

BOOST_AUTO_TEST_CASE(springs_survive_lists_and_sorting) {
    // A spinning grain comes to rest in the valley of two frozen ones. With a fast grain far above,
    // which makes a list every few steps, nothing changes for it.
    auto p = frictional_discs(0.5, 0.05, 50);
    p.gravity = 1;
    p.period_x = 12;
    friction::State alone;
    add(alone, {.x = 5.5, .y = 0, .vx = 0, .vy = 0}, true);
    add(alone, {.x = 6.45, .y = -0.1, .vx = 0, .vy = 0}, true);
    add(alone, {.x = 6.0, .y = 0.868, .vx = 0, .vy = 0, .omega = 3});
    auto watched = alone;
    add(watched, {.x = 1.0, .y = 300, .vx = 40, .vy = 17});
    for (const auto kernel : kernels()) {
        for (const auto& conventions : all_conventions()) {
            p.kernel = kernel;
            p.contact.conventions = conventions;
            friction::Engine many_lists(p, watched), few_lists(p, alone);
            many_lists.advance(3000);
            few_lists.advance(3000);
            BOOST_TEST(many_lists.effort().neighbour_builds >
                       few_lists.effort().neighbour_builds + 20);
            const auto &a = many_lists.state(), &b = few_lists.state();
            BOOST_TEST(std::abs(a.omega[2]) < 1.0);
            BOOST_TEST(std::abs(a.x[2] - b.x[2]) < 1e-11);
            BOOST_TEST(std::abs(a.omega[2] - b.omega[2]) < 1e-9);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_contact_that_has_opened_leaves_no_spring_behind) {
    // Planes throw a sliding pair together again and again. Between two collisions a new engine,
    // which cannot know of any spring, carries on as the old one.
    auto p = frictional_discs(1, 0.02, 200);
    p.backing = friction::BackingPlanes{.stiffness = 1e4, .left = -0.51, .right = 0.52};
    for (const auto kernel : kernels()) {
        for (const auto& conventions : all_conventions()) {
            p.kernel = kernel;
            p.contact.conventions = conventions;
            friction::Engine old(p, colliding_pair(-0.3));
            const auto gap = [&] {
                const auto& s = old.state();
                return std::hypot(s.x[0] - s.x[1], s.y[0] - s.y[1]) - 1;
            };
            int collisions = 0;
            for (bool touched = false; collisions < 2 || touched; touched = gap() <= 0) {
                old.advance(10);
                if (!touched && gap() <= 0) ++collisions;
            }
            friction::Engine fresh(p, old.state());
            fresh.advance(400);
            old.advance(400);
            BOOST_TEST(largest_difference(fresh.state(), old.state()) < 1e-10);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_run_cut_in_pieces_is_the_same_bit_for_bit) {
    auto p = gas_parameters();
    p.gravity = 1;
    p.drag = 0.1;
    const auto start = hot_gas(17, 16, 1.4, 9);
    p.period_x = p.period_y = 24;
    for (const auto kernel : kernels()) {
        const auto once = with(p, kernel, start, 300);
        p.kernel = kernel;
        friction::Engine engine(p, start);
        BOOST_TEST((engine.state().x == start.x && engine.state().radius == start.radius));
        for (const std::int64_t piece : {1, 2, 0, 7, 140, 150}) {
            engine.advance(piece);
            (void)engine.state();
        }
        BOOST_TEST(engine.state().step == 300);
        BOOST_TEST(largest_difference(once, engine.state()) == 0.0);
    }
}

BOOST_AUTO_TEST_CASE(every_instruction_set_agrees_or_says_that_it_cannot) {
    auto p = gas_parameters();
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        BOOST_TEST_CONTEXT(hwy::TargetName(target)) {
            for (const auto& conventions : all_conventions()) {
                p.contact.conventions = conventions;
                BOOST_TEST(disagreement(p, hot_gas(10, 10, 1.5, 13)) < grown_round_off);
            }
            p.kernel = friction::Kernel::simd;
            if (friction::simd_lanes() == 0) {
                BOOST_CHECK_THROW(friction::Engine(p, hot_gas(10, 10, 1.5)), std::invalid_argument);
            }
        }
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

BOOST_AUTO_TEST_CASE(small_systems_run_on_the_scalar_kernel) {
    auto p = gas_parameters();
    friction::Engine small(p, hot_gas(8, 8, 1.8));
    BOOST_TEST(small.effort().kernel == "scalar");
    p.period_x = p.period_y = 30;
    friction::Engine large(p, hot_gas(18, 18, 1.6));
    const bool simd = large.effort().kernel.starts_with("simd");
    BOOST_TEST(simd == (friction::simd_lanes() > 0));
}
