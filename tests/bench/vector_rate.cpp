#include "tests/bench/vector_rate.hpp"

#include "native/base/cpu_time.hpp"

#include <algorithm>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/vector_rate.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace crossgrain::bench {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Sixteen chains, four of each kind: enough to fill units that take four cycles for a sum, few
/// enough for the registers. Returns a sum of them, so that nothing is left out.
float Mix(std::int64_t rounds) {
    const hn::ScalableTag<float> d;
    const auto b = hn::Set(d, 0.999F), c = hn::Set(d, 1e-3F);
    auto p0 = hn::Iota(d, 1), p1 = hn::Iota(d, 2), p2 = hn::Iota(d, 3), p3 = hn::Iota(d, 4);
    auto s0 = p0, s1 = p1, s2 = p2, s3 = p3;
    auto m0 = p0, m1 = p1, m2 = p2, m3 = p3;
    auto x0 = p0, x1 = p1, x2 = p2, x3 = p3;
    for (std::int64_t i = 0; i < rounds; ++i) {
        p0 = hn::MulAdd(p0, b, c), p1 = hn::MulAdd(p1, b, c);
        p2 = hn::MulAdd(p2, b, c), p3 = hn::MulAdd(p3, b, c);
        s0 = hn::Sub(c, s0), s1 = hn::Sub(c, s1), s2 = hn::Sub(c, s2), s3 = hn::Sub(c, s3);
        m0 = hn::Max(m0, p0), m1 = hn::Max(m1, p1), m2 = hn::Max(m2, p2), m3 = hn::Max(m3, p3);
        x0 = hn::Xor(x0, s0), x1 = hn::Xor(x1, s1), x2 = hn::Xor(x2, s2), x3 = hn::Xor(x3, s3);
    }
    auto sum = hn::Add(hn::Add(hn::Add(m0, m1), hn::Add(m2, m3)), hn::Add(p0, p1));
    sum = hn::Add(sum, hn::Add(hn::Abs(hn::Add(x0, x1)), hn::Abs(hn::Add(x2, x3))));
    return hn::GetLane(hn::SumOfLanes(d, sum));
}

}  // namespace HWY_NAMESPACE
}  // namespace crossgrain::bench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace crossgrain::bench {

HWY_EXPORT(Mix);

double widest_vector_instructions_per_second() {
    constexpr std::int64_t rounds = 200'000;
    constexpr double instructions = 16.0 * rounds;
    double fastest = 0;
    volatile float seen = 0;
    for (int attempt = 0; attempt < 20; ++attempt) {
        const double start = thread_cpu_seconds();
        seen = HWY_DYNAMIC_DISPATCH(Mix)(rounds);
        fastest = std::max(fastest, instructions / (thread_cpu_seconds() - start));
    }
    static_cast<void>(seen);
    return fastest;
}

}  // namespace crossgrain::bench
#endif
