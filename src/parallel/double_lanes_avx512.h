#pragma once

// Eight numbers at a time, for x86-64 processors with AVX-512.
// To be included by a file of kernels for this instruction set alone: everything is static, so that no code for a
// special processor can be taken for that of the rest of the program. KERNEL_CODE is what functions must carry that are
// expanded in place, KERNEL_ENTRY those that are called.

#include <cstddef>
#include <immintrin.h>

#define KERNEL_CODE __attribute__((always_inline, target("avx512f"))) inline
#define KERNEL_ENTRY __attribute__((target("avx512f")))

namespace multipath {
namespace {

struct DoubleLanes
{
    static constexpr std::size_t width = 8;
    __m512d x;

    KERNEL_CODE static DoubleLanes load(const double* from) { return {_mm512_loadu_pd(from)}; }
    KERNEL_CODE static DoubleLanes load_floats(const float* from)
    {
        return {_mm512_maskz_cvtps_pd(0xff, _mm256_loadu_ps(from))};
    }
    KERNEL_CODE static DoubleLanes all(double value) { return {_mm512_set1_pd(value)}; }
    KERNEL_CODE void store(double* to) const { _mm512_storeu_pd(to, x); }
};

KERNEL_CODE DoubleLanes operator+(DoubleLanes a, DoubleLanes b)
{
    return {_mm512_add_pd(a.x, b.x)};
}
KERNEL_CODE DoubleLanes operator-(DoubleLanes a, DoubleLanes b)
{
    return {_mm512_sub_pd(a.x, b.x)};
}
KERNEL_CODE DoubleLanes operator*(DoubleLanes a, DoubleLanes b)
{
    return {_mm512_mul_pd(a.x, b.x)};
}
KERNEL_CODE DoubleLanes square_root(DoubleLanes a)
{
    return {_mm512_maskz_sqrt_pd(0xff, a.x)};
}
KERNEL_CODE DoubleLanes choose_less(DoubleLanes a, DoubleLanes b, DoubleLanes yes, DoubleLanes no)
{
    return {_mm512_mask_blend_pd(_mm512_cmp_pd_mask(a.x, b.x, _CMP_LT_OQ), no.x, yes.x)};
}
template <int bit>
KERNEL_CODE DoubleLanes sign_from_bit(DoubleLanes a)
{
    const __m512i top = _mm512_maskz_slli_epi64(0xff, _mm512_castpd_si512(a.x), 63 - bit);
    return {_mm512_castsi512_pd(_mm512_and_epi64(top, _mm512_set1_epi64(-0x7fffffffffffffff - 1)))};
}
KERNEL_CODE DoubleLanes choose_by_sign(DoubleLanes sign, DoubleLanes yes, DoubleLanes no)
{
    const __mmask8 negative = _mm512_cmp_epi64_mask(_mm512_castpd_si512(sign.x), _mm512_setzero_si512(), _MM_CMPINT_LT);
    return {_mm512_mask_blend_pd(negative, no.x, yes.x)};
}
KERNEL_CODE DoubleLanes with_sign(DoubleLanes sign, DoubleLanes a)
{
    return {_mm512_castsi512_pd(_mm512_xor_epi64(_mm512_castpd_si512(a.x), _mm512_castpd_si512(sign.x)))};
}

} // namespace
} // namespace multipath
