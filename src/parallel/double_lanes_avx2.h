#pragma once

// Four numbers at a time, for x86-64 processors with AVX2.
// To be included by a file of kernels for this instruction set alone: everything is static, so that no code for a
// special processor can be taken for that of the rest of the program. KERNEL_CODE is what functions must carry that are
// expanded in place, KERNEL_ENTRY those that are called.

#include <cstddef>
#include <immintrin.h>

#define KERNEL_CODE __attribute__((always_inline, target("avx2"))) inline
#define KERNEL_ENTRY __attribute__((target("avx2")))

namespace multipath {
namespace {

struct DoubleLanes
{
    static constexpr std::size_t width = 4;
    __m256d x;

    KERNEL_CODE static DoubleLanes load(const double* from) { return {_mm256_loadu_pd(from)}; }
    KERNEL_CODE static DoubleLanes load_floats(const float* from) { return {_mm256_cvtps_pd(_mm_loadu_ps(from))}; }
    KERNEL_CODE static DoubleLanes all(double value) { return {_mm256_set1_pd(value)}; }
    KERNEL_CODE void store(double* to) const { _mm256_storeu_pd(to, x); }
};

KERNEL_CODE DoubleLanes operator+(DoubleLanes a, DoubleLanes b)
{
    return {_mm256_add_pd(a.x, b.x)};
}
KERNEL_CODE DoubleLanes operator-(DoubleLanes a, DoubleLanes b)
{
    return {_mm256_sub_pd(a.x, b.x)};
}
KERNEL_CODE DoubleLanes operator*(DoubleLanes a, DoubleLanes b)
{
    return {_mm256_mul_pd(a.x, b.x)};
}
KERNEL_CODE DoubleLanes square_root(DoubleLanes a)
{
    return {_mm256_sqrt_pd(a.x)};
}
KERNEL_CODE DoubleLanes choose_less(DoubleLanes a, DoubleLanes b, DoubleLanes yes, DoubleLanes no)
{
    return {_mm256_blendv_pd(no.x, yes.x, _mm256_cmp_pd(a.x, b.x, _CMP_LT_OQ))};
}
template <int bit>
KERNEL_CODE DoubleLanes sign_from_bit(DoubleLanes a)
{
    const __m256i top = _mm256_slli_epi64(_mm256_castpd_si256(a.x), 63 - bit);
    return {_mm256_and_pd(_mm256_castsi256_pd(top), _mm256_set1_pd(-0.0))};
}
KERNEL_CODE DoubleLanes choose_by_sign(DoubleLanes sign, DoubleLanes yes, DoubleLanes no)
{
    return {_mm256_blendv_pd(no.x, yes.x, sign.x)};
}
KERNEL_CODE DoubleLanes with_sign(DoubleLanes sign, DoubleLanes a)
{
    return {_mm256_xor_pd(a.x, sign.x)};
}

} // namespace
} // namespace multipath
