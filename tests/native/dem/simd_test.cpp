// The simd kernel is the scalar one, faster: the same trajectories to round-off in double
// precision, to a documented bound in mixed precision, whatever the number of threads and however
// often one looks.
#include "native/base/errors.hpp"
#include "native/base/instruction_sets.hpp"
#include "tests/native/dem/simd_bed.hpp"

#include <boost/test/unit_test.hpp>
#include <hwy/targets.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

constexpr auto ten_contacts = static_cast<std::int64_t>(10 * contact_time / dt);

/// What becomes of a displacement of all grains by so much at the start: collisions amplify it, and
/// rounding errors likewise.
double what_becomes_of(double displacement, const dem::Parameters& p, std::int64_t steps,
                       const dem::State& from = bed()) {
    auto start = from;
    for (std::uint64_t i = 0; i < start.x.size(); ++i) {
        const auto sign = normal_pair(11, RandomStream::jitter, i);
        start.x[i] += std::copysign(displacement, sign[0]);
        start.y[i] += std::copysign(displacement, sign[1]);
    }
    return largest_difference(scalar(p, steps, start), scalar(p, steps, from));
}

/// The bounds that are promised: an error like that of displacing the grains by so much at the
/// start. Positions are below 30, velocities below 10 here.
constexpr double double_bound = 2e-13, mixed_bound = 1e-5;

void check_against_scalar(const dem::Parameters& p, std::int64_t steps) {
    const auto truth = scalar(p, steps);
    BOOST_TEST(largest_difference(simd(p, steps), truth) < what_becomes_of(double_bound, p, steps));
    BOOST_TEST(largest_difference(mixed(p, steps), truth) < what_becomes_of(mixed_bound, p, steps));
}

}  // namespace

BOOST_AUTO_TEST_CASE(trajectories_are_those_of_the_scalar_kernel_within_the_bounds) {
    for (const auto& law : law_variants) {
        for (const auto scheme : both_schemes) {
            BOOST_TEST_CONTEXT(law.name) {
                check_against_scalar(bed_parameters(law, scheme), ten_contacts);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(for_a_contact_time_the_errors_are_those_of_rounding) {
    for (const auto scheme : both_schemes) {
        const auto p = bed_parameters(law_variants[0], scheme);
        const auto truth = scalar(p, 100);
        BOOST_TEST(largest_distance(simd(p, 100), truth) < 1e-12);
        BOOST_TEST(largest_distance(mixed(p, 100), truth) < 1e-6);
    }
}

BOOST_AUTO_TEST_CASE(every_instruction_set_of_this_machine_keeps_the_bounds) {
    // The next machine may lack AVX-512.
    const auto p = bed_parameters(law_variants[3], dem::Scheme::verlet_predicted);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        BOOST_TEST_CONTEXT(hwy::TargetName(target)) {
            if (dem::why_not_simd(p, bed())) continue;  // the plain C++ of a machine without any
            auto q = p;
            q.kernel = dem::Kernel::simd;
            BOOST_TEST(dem::Engine(q, bed()).effort().kernel.find(hwy::TargetName(target)) !=
                       std::string::npos);
            check_against_scalar(p, 500);
        }
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

BOOST_AUTO_TEST_CASE(a_machine_without_avx512_can_be_played) {
    const bool before = has_avx512();
    auto p = bed_parameters(law_variants[0], dem::Scheme::verlet_predicted);
    p.kernel = dem::Kernel::simd;
    {
        const WithoutAvx512 older;
        BOOST_TEST(!has_avx512());
        if (dem::why_not_simd(p, bed())) return;
        BOOST_TEST(dem::Engine(p, bed()).effort().kernel.find("AVX3") == std::string::npos);
    }
    BOOST_TEST(has_avx512() == before);
    BOOST_TEST((dem::Engine(p, bed()).effort().kernel.find("AVX3") != std::string::npos) == before);
}

BOOST_AUTO_TEST_CASE(every_kind_of_boundary_is_that_of_the_scalar_kernel) {
    const auto closed = bed_parameters(law_variants[0], dem::Scheme::verlet_predicted);
    auto surface = closed;
    surface.plate_reach = 1;
    surface.bottom->height -= 1;
    auto prescribed_lid = closed;
    prescribed_lid.lid = dem::MovingPlate{.height = 18, .amplitude = 1, .omega = 1};
    auto no_lid = closed;
    no_lid.lid = {};
    auto open = no_lid;
    open.period_x = {};
    auto nothing = open;
    nothing.bottom = {};
    nothing.gravity = 0;
    for (const auto& p : {surface, prescribed_lid, no_lid, open, nothing})
        check_against_scalar(p, 500);
}

BOOST_AUTO_TEST_CASE(mixed_precision_keeps_momentum_and_energy_to_the_rounding_of_floats) {
    auto p = free_discs(law_variants[0], dt);
    p.damping = 0;
    p.period_x = 65;
    const auto start = bed(301, 32, 1.0);
    const auto end = mixed(p, 2000, start);
    const auto before = momentum(p, start), behind = momentum(p, end);
    // 301 velocities of order 1, rounded 2000 times at 6e-8, adding up at random: 5e-5.
    BOOST_TEST(std::abs(behind[0] - before[0]) < 2e-4);
    BOOST_TEST(std::abs(behind[1] - before[1]) < 2e-4);
    const double energy = pair_energy(p, start);
    const double scheme = std::abs(pair_energy(p, scalar(p, 2000, start)) - energy);
    BOOST_TEST(std::abs(pair_energy(p, end) - energy) < 2 * scheme + 1e-4 * energy);
}

BOOST_AUTO_TEST_CASE(positions_far_from_the_origin_lose_nothing_in_mixed_precision) {
    // A bed of the width of 100 000 grains has floats 1e-3 apart at its end; integers have not.
    auto p = bed_parameters(law_variants[0], dem::Scheme::verlet_predicted);
    p.period_x = 65.0 * 200;
    auto start = bed();
    for (double& x : start.x)
        x += 65.0 * 190;
    BOOST_TEST(largest_distance(mixed(p, 300, start), scalar(p, 300, start)) < 1e-4);
}

BOOST_AUTO_TEST_CASE(looking_changes_nothing) {
    for (const auto precision : {dem::Precision::double_precision, dem::Precision::mixed}) {
        for (const auto scheme : both_schemes) {
            auto p = bed_parameters(law_variants[0], scheme);
            p.kernel = dem::Kernel::simd;
            p.precision = precision;
            dem::Engine looked_at(p, bed());
            for (int i = 0; i < 600; i += 1 + i % 7) {
                looked_at.advance(1 + i % 7);
                BOOST_REQUIRE(looked_at.state().x.size() == 301);
            }
            const auto straight = after(p, bed(), looked_at.state().step);
            BOOST_TEST(largest_difference(looked_at.state(), straight) == 0);
        }
    }
}

BOOST_AUTO_TEST_CASE(the_number_of_threads_changes_nothing) {
    auto p = bed_parameters(law_variants[0], dem::Scheme::verlet_half_step);
    p.period_x = 65.0 * 30;
    const auto start = bed(9001, std::size_t{32} * 30);
    for (const auto precision : {dem::Precision::double_precision, dem::Precision::mixed}) {
        p.precision = precision;
        p.kernel = dem::Kernel::simd;
        p.threads = 1;
        const auto alone = after(p, start, 200);
        p.threads = 2;
        dem::Engine together(p, start);
        together.advance(200);
        BOOST_TEST(together.effort().kernel.find("2 threads") != std::string::npos);
        BOOST_TEST(largest_difference(together.state(), alone) == 0);
    }
}

BOOST_AUTO_TEST_CASE(a_list_is_made_anew_in_time_whatever_the_skin) {
    const auto p = bed_parameters(law_variants[0], dem::Scheme::verlet_half_step);
    const auto truth = scalar(p, 500);
    const double double_error = what_becomes_of(double_bound, p, 500);
    const double mixed_error = what_becomes_of(mixed_bound, p, 500);
    for (const double skin : {0.05, 0.3, 1.5}) {
        auto q = p;
        q.skin = skin;
        BOOST_TEST_CONTEXT("skin " << skin) {
            BOOST_TEST(largest_difference(simd(q, 500), truth) < double_error);
            BOOST_TEST(largest_difference(mixed(q, 500), truth) < mixed_error);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_bed_in_free_flight_needs_no_new_list_and_loses_no_contact) {
    // All fly up together, faster than any grain moves against another, and come down on the plate.
    auto p = bed_parameters(law_variants[0], dem::Scheme::verlet_predicted);
    p.lid = {};
    auto start = bed();
    for (double& vy : start.vy)
        vy += 20;
    const auto truth = scalar(p, 3000, start);
    BOOST_TEST(truth.y[0] > 20);
    // Heights reach 200, and the unit of length follows.
    BOOST_TEST(largest_difference(simd(p, 3000, start), truth) <
               what_becomes_of(double_bound, p, 3000, start));
    BOOST_TEST(largest_difference(mixed(p, 3000, start), truth) <
               what_becomes_of(mixed_bound, p, 3000, start));
}

// Nothing accelerates them, so that nothing limits how late a row may be due.
BOOST_AUTO_TEST_CASE(grains_without_springs_fly_through_each_other) {
    auto p = bed_parameters(law_variants[0], dem::Scheme::verlet_half_step);
    p.stiffness = p.damping = p.gravity = 0;
    p.bottom = {};
    p.lid = {};
    const auto start = bed(301, 32, 3);
    constexpr std::int64_t steps = 2000;
    const auto end = simd(p, steps, start);
    double largest = 0;
    for (std::size_t i = 0; i < start.x.size(); ++i) {
        largest = std::max(largest, std::hypot(end.x[i] - start.x[i] - steps * dt * start.vx[i],
                                               end.y[i] - start.y[i] - steps * dt * start.vy[i]));
    }
    BOOST_TEST(largest < 1e-10);
}

BOOST_AUTO_TEST_CASE(a_run_that_has_blown_up_stops) {
    for (const auto precision : {dem::Precision::double_precision, dem::Precision::mixed}) {
        auto p = bed_parameters(law_variants[0], dem::Scheme::verlet_half_step);
        p.precision = precision;
        p.kernel = dem::Kernel::simd;
        for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                                 std::numeric_limits<double>::infinity(), 1e300}) {
            auto start = bed();
            start.y[150] = bad;
            BOOST_CHECK_THROW(after(p, start, 1), TrajectoryError);
            start = bed();
            start.vx[300] = bad;
            BOOST_CHECK_THROW(after(p, start, 1), TrajectoryError);
        }
        // The normal of two grains on the same spot is 0/0.
        auto start = bed();
        start.x[7] = start.x[8];
        start.y[7] = start.y[8];
        BOOST_CHECK_THROW(after(p, start, 2), TrajectoryError);
        // Far beyond the largest stable step.
        p.dt = 0.5;
        BOOST_CHECK_THROW(after(p, bed(), 2000), TrajectoryError);
    }
}

BOOST_AUTO_TEST_CASE(what_the_kernel_lacks_is_refused_in_words) {
    const auto p = bed_parameters(law_variants[0], dem::Scheme::verlet_half_step);
    const auto refuses = [&](dem::Parameters q, dem::State s) {
        q.kernel = dem::Kernel::simd;
        BOOST_TEST(dem::why_not_simd(q, s).has_value());
        BOOST_CHECK_THROW(dem::Engine(q, s), std::invalid_argument);
        q.kernel = dem::Kernel::automatic;
        BOOST_TEST(dem::Engine(q, s).effort().kernel == "scalar");
    };
    BOOST_TEST(!dem::why_not_simd(p, bed()).has_value());
    auto q = p;
    q.scheme = dem::Scheme::runge_kutta_4;
    refuses(q, bed());
    q = p;
    q.contacts = dem::Contacts::lattice_neighbours;
    refuses(q, bed());
    auto obstacles = bed();
    obstacles.frozen = {3};
    refuses(p, obstacles);
    q = p;
    q.period_y = 200;
    refuses(q, bed());
    q = p;
    q.kernel = dem::Kernel::scalar;
    q.precision = dem::Precision::mixed;
    BOOST_CHECK_THROW(dem::Engine(q, bed()), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(small_systems_and_the_parity_scheme_stay_on_the_scalar_kernel) {
    const auto kernel = [](dem::Scheme scheme, std::size_t grains) {
        return dem::Engine(bed_parameters(law_variants[0], scheme), bed(grains)).effort().kernel;
    };
    BOOST_TEST(kernel(dem::Scheme::verlet_predicted, 100) == "scalar");
    BOOST_TEST(kernel(dem::Scheme::verlet_predicted, 301) != "scalar");
    BOOST_TEST(kernel(dem::Scheme::verlet_half_step, 301) == "scalar");
}
