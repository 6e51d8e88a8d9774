// The reciprocal root that the contact law divides by, per instruction set (Highway).
// Included once per instruction set: no include guard but the one Highway asks for.
#if defined(CROSSGRAIN_DEM_SIMD_RECIPROCAL_ROOT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROSSGRAIN_DEM_SIMD_RECIPROCAL_ROOT_INL
#undef CROSSGRAIN_DEM_SIMD_RECIPROCAL_ROOT_INL
#else
#define CROSSGRAIN_DEM_SIMD_RECIPROCAL_ROOT_INL
#endif

#include <hwy/highway.h>

#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace crossgrain::dem {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

/// 1/sqrt(v) = guess + correction, where the guess has some bits and the correction the others;
/// no numbers for v = 0. They are apart because what is made of them goes on with the guess while
/// the correction is still being computed.
template <class D>
class ReciprocalRoot {
    using T = hn::TFromD<D>;

  public:
    HWY_INLINE explicit ReciprocalRoot(hn::Vec<D> v) : guess_(Guess(v)), share_(Share(v, guess_)) {}

    /// a/sqrt(v) - b
    [[nodiscard]] HWY_INLINE hn::Vec<D> TimesLess(hn::Vec<D> a, hn::Vec<D> b) const {
        return hn::MulAdd(hn::Mul(guess_, a), share_, hn::MulSub(guess_, a, b));
    }
    [[nodiscard]] HWY_INLINE hn::Vec<D> Value() const { return hn::MulAdd(guess_, share_, guess_); }

  private:
    static HWY_INLINE hn::Vec<D> Guess(hn::Vec<D> v) {
        if constexpr (std::is_same_v<T, float>) {
            return hn::ApproximateReciprocalSqrt(v);
        } else {
#if HWY_TARGET <= HWY_AVX3
            return hn::Vec<D>{_mm512_rsqrt14_pd(v.raw)};
#else
            const D d;
            const hn::Rebind<float, D> narrow;
            const auto guess =
                hn::PromoteTo(d, hn::ApproximateReciprocalSqrt(hn::DemoteTo(narrow, v)));
#if HWY_ARCH_X86
            return guess;
#else
            // Newton: guess (1 + (1 - v guess^2)/2) has twice as many good bits.
            const auto half = hn::Set(d, 0.5);
            const auto half_residual = hn::NegMulAdd(hn::Mul(v, half), hn::Mul(guess, guess), half);
            return hn::MulAdd(guess, half_residual, guess);
#endif
#endif
        }
    }
    /// With h = 1 - v guess^2: 1/sqrt(v) = guess (1 - h)^(-1/2)
    ///                           = guess (1 + h/2 + 3 h^2/8 + 5 h^3/16 + 35 h^4/128 + ...),
    /// as far as it takes: |h| <= 2^-13 with AVX-512, 7.4e-4 with the older instruction of x86,
    /// which is good for 1.5/2^12, and below 2^-14 after Newton elsewhere.
    static HWY_INLINE hn::Vec<D> Share(hn::Vec<D> v, hn::Vec<D> guess) {
        const D d;
        const auto half = hn::Set(d, T(0.5));
        const auto squared = hn::Mul(guess, guess);
        if constexpr (std::is_same_v<T, float>) {
            return hn::NegMulAdd(hn::Mul(v, half), squared, half);
        } else {
            const auto h = hn::NegMulAdd(v, squared, hn::Set(d, 1.0));
#if HWY_ARCH_X86 && HWY_TARGET > HWY_AVX3
            const auto near = hn::MulAdd(h, hn::Set(d, 3.0 / 8), half);
            const auto far = hn::MulAdd(h, hn::Set(d, 35.0 / 128), hn::Set(d, 5.0 / 16));
            return hn::Mul(h, hn::MulAdd(hn::Mul(h, h), far, near));
#else
            const auto tail = hn::MulAdd(h, hn::Set(d, 5.0 / 16), hn::Set(d, 3.0 / 8));
            return hn::Mul(h, hn::MulAdd(h, tail, half));
#endif
        }
    }

    hn::Vec<D> guess_, share_;  ///< correction = guess share
};

#endif  // HWY_TARGET != HWY_SCALAR

}  // namespace HWY_NAMESPACE
}  // namespace crossgrain::dem
HWY_AFTER_NAMESPACE();

#endif
