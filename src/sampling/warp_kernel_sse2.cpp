// The maps for every x86-64 processor: 2 points at a time.

#include "sampling/warp_kernels.h"

#if defined(__x86_64__)

#include <immintrin.h>

#define KERNEL_CODE __attribute__((always_inline, target("sse2"))) inline
#define KERNEL_ENTRY __attribute__((target("sse2")))

namespace multipath {
namespace {

struct Lanes
{
    static constexpr std::size_t width = 2;
    __m128d x;

    KERNEL_CODE static Lanes load(const double* from) { return {_mm_load_pd(from)}; }
    KERNEL_CODE static Lanes all(double value) { return {_mm_set1_pd(value)}; }
    KERNEL_CODE void store(double* to) const { _mm_store_pd(to, x); }
};

KERNEL_CODE Lanes operator+(Lanes a, Lanes b)
{
    return {_mm_add_pd(a.x, b.x)};
}
KERNEL_CODE Lanes operator-(Lanes a, Lanes b)
{
    return {_mm_sub_pd(a.x, b.x)};
}
KERNEL_CODE Lanes operator*(Lanes a, Lanes b)
{
    return {_mm_mul_pd(a.x, b.x)};
}
KERNEL_CODE Lanes square_root(Lanes a)
{
    return {_mm_sqrt_pd(a.x)};
}
KERNEL_CODE Lanes choose(__m128d mask, Lanes yes, Lanes no)
{
    return {_mm_or_pd(_mm_and_pd(mask, yes.x), _mm_andnot_pd(mask, no.x))};
}
KERNEL_CODE Lanes choose_less(Lanes a, Lanes b, Lanes yes, Lanes no)
{
    return choose(_mm_cmplt_pd(a.x, b.x), yes, no);
}
template <int bit>
KERNEL_CODE Lanes sign_from_bit(Lanes a)
{
    const __m128i top = _mm_slli_epi64(_mm_castpd_si128(a.x), 63 - bit);
    return {_mm_and_pd(_mm_castsi128_pd(top), _mm_set1_pd(-0.0))};
}
KERNEL_CODE Lanes choose_by_sign(Lanes sign, Lanes yes, Lanes no)
{
    const __m128i halves = _mm_srai_epi32(_mm_castpd_si128(sign.x), 31); // of each number the upper half is right
    return choose(_mm_castsi128_pd(_mm_shuffle_epi32(halves, 0xf5)), yes, no);
}
KERNEL_CODE Lanes with_sign(Lanes sign, Lanes a)
{
    return {_mm_xor_pd(a.x, sign.x)};
}

} // namespace
} // namespace multipath

#include "sampling/lane_warp.inl"

namespace multipath {

const WarpKernel sse2_warp_kernel = {"sse2", uniform_sphere, cosine_hemisphere};

} // namespace multipath

#endif
