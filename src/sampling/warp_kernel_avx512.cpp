// The maps for x86-64 processors with AVX-512: 8 points at a time.

#include "sampling/warp_kernels.h"

#if defined(__x86_64__)

#include <immintrin.h>

#define KERNEL_CODE __attribute__((always_inline, target("avx512f"))) inline
#define KERNEL_ENTRY __attribute__((target("avx512f")))

namespace multipath {
namespace {

struct Lanes
{
    static constexpr std::size_t width = 8;
    __m512d x;

    KERNEL_CODE static Lanes load(const double* from) { return {_mm512_load_pd(from)}; }
    KERNEL_CODE static Lanes all(double value) { return {_mm512_set1_pd(value)}; }
    KERNEL_CODE void store(double* to) const { _mm512_store_pd(to, x); }
};

KERNEL_CODE Lanes operator+(Lanes a, Lanes b)
{
    return {_mm512_add_pd(a.x, b.x)};
}
KERNEL_CODE Lanes operator-(Lanes a, Lanes b)
{
    return {_mm512_sub_pd(a.x, b.x)};
}
KERNEL_CODE Lanes operator*(Lanes a, Lanes b)
{
    return {_mm512_mul_pd(a.x, b.x)};
}
KERNEL_CODE Lanes square_root(Lanes a)
{
    return {_mm512_maskz_sqrt_pd(0xff, a.x)};
}
KERNEL_CODE Lanes choose_less(Lanes a, Lanes b, Lanes yes, Lanes no)
{
    return {_mm512_mask_blend_pd(_mm512_cmp_pd_mask(a.x, b.x, _CMP_LT_OQ), no.x, yes.x)};
}
template <int bit>
KERNEL_CODE Lanes sign_from_bit(Lanes a)
{
    const __m512i top = _mm512_maskz_slli_epi64(0xff, _mm512_castpd_si512(a.x), 63 - bit);
    return {_mm512_castsi512_pd(_mm512_and_epi64(top, _mm512_set1_epi64(-0x7fffffffffffffff - 1)))};
}
KERNEL_CODE Lanes choose_by_sign(Lanes sign, Lanes yes, Lanes no)
{
    const __mmask8 negative = _mm512_cmp_epi64_mask(_mm512_castpd_si512(sign.x), _mm512_setzero_si512(), _MM_CMPINT_LT);
    return {_mm512_mask_blend_pd(negative, no.x, yes.x)};
}
KERNEL_CODE Lanes with_sign(Lanes sign, Lanes a)
{
    return {_mm512_castsi512_pd(_mm512_xor_epi64(_mm512_castpd_si512(a.x), _mm512_castpd_si512(sign.x)))};
}

} // namespace
} // namespace multipath

#include "sampling/lane_warp.inl"

namespace multipath {

const WarpKernel avx512_warp_kernel = {"avx512", uniform_sphere, cosine_hemisphere};

} // namespace multipath

#endif
