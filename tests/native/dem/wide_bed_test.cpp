// Protects what the simd kernel does with beds that no cache holds.
#include "tests/native/dem/simd_bed.hpp"

#include <boost/test/unit_test.hpp>

using namespace crossgrain;
using namespace crossgrain::tests;

// More records than a cache holds are stored past it, by both threads: every part of a bed of many
// equal parts must still do what the bed does that it is a part of.
BOOST_AUTO_TEST_CASE(a_bed_that_no_cache_holds_is_many_small_ones) {
    constexpr std::size_t parts = 1900, steps = 60;  // 572,000 grains of 32 bytes
    auto p = bed_parameters(law_variants[0], dem::Scheme::verlet_predicted);
    const auto narrow = simd(p, steps);
    const auto start = bed();
    dem::State wide{.lid_height = start.lid_height};
    for (std::size_t part = 0; part < parts; ++part) {
        for (std::size_t i = 0; i < start.x.size(); ++i) {
            add_disc(wide, start.x[i] + 65.0 * static_cast<double>(part), start.y[i], start.vx[i],
                     start.vy[i]);
        }
    }
    p.period_x = 65.0 * parts;
    p.lid = dem::InertialLid{.mass = 50.0 * parts};
    p.threads = 2;
    const auto after_steps = simd(p, steps, wide);
    double largest = 0;
    for (std::size_t i = 0; i < wide.x.size(); ++i) {
        const std::size_t own = i % start.x.size();
        const double x = 65.0 * static_cast<double>(i / start.x.size()) + narrow.x[own];
        largest =
            std::max(largest, std::hypot(after_steps.x[i] - x, after_steps.y[i] - narrow.y[own]));
    }
    BOOST_TEST(largest < 1e-9);  // positions up to 1e5, 1e-11 of rounding each
}
