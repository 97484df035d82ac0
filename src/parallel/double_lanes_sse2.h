#pragma once

// Two numbers at a time, for every x86-64 processor.
// To be included by a file of kernels for this instruction set alone: everything is static, so that no code for a
// special processor can be taken for that of the rest of the program. KERNEL_CODE is what functions must carry that are
// expanded in place, KERNEL_ENTRY those that are called.

#include <cstddef>
#include <emmintrin.h>

#define KERNEL_CODE __attribute__((always_inline, target("sse2"))) inline
#define KERNEL_ENTRY __attribute__((target("sse2")))

namespace multipath {
namespace {

struct DoubleLanes
{
    static constexpr std::size_t width = 2;
    __m128d x;

    KERNEL_CODE static DoubleLanes load(const double* from) { return {_mm_loadu_pd(from)}; }
    KERNEL_CODE static DoubleLanes load_floats(const float* from) { return {_mm_set_pd(from[1], from[0])}; }
    KERNEL_CODE static DoubleLanes all(double value) { return {_mm_set1_pd(value)}; }
    KERNEL_CODE void store(double* to) const { _mm_storeu_pd(to, x); }
};

KERNEL_CODE DoubleLanes operator+(DoubleLanes a, DoubleLanes b)
{
    return {_mm_add_pd(a.x, b.x)};
}
KERNEL_CODE DoubleLanes operator-(DoubleLanes a, DoubleLanes b)
{
    return {_mm_sub_pd(a.x, b.x)};
}
KERNEL_CODE DoubleLanes operator*(DoubleLanes a, DoubleLanes b)
{
    return {_mm_mul_pd(a.x, b.x)};
}
KERNEL_CODE DoubleLanes square_root(DoubleLanes a)
{
    return {_mm_sqrt_pd(a.x)};
}
KERNEL_CODE DoubleLanes choose(__m128d mask, DoubleLanes yes, DoubleLanes no)
{
    return {_mm_or_pd(_mm_and_pd(mask, yes.x), _mm_andnot_pd(mask, no.x))};
}
KERNEL_CODE DoubleLanes choose_less(DoubleLanes a, DoubleLanes b, DoubleLanes yes, DoubleLanes no)
{
    return choose(_mm_cmplt_pd(a.x, b.x), yes, no);
}
template <int bit>
KERNEL_CODE DoubleLanes sign_from_bit(DoubleLanes a)
{
    const __m128i top = _mm_slli_epi64(_mm_castpd_si128(a.x), 63 - bit);
    return {_mm_and_pd(_mm_castsi128_pd(top), _mm_set1_pd(-0.0))};
}
KERNEL_CODE DoubleLanes choose_by_sign(DoubleLanes sign, DoubleLanes yes, DoubleLanes no)
{
    const __m128i halves = _mm_srai_epi32(_mm_castpd_si128(sign.x), 31); // of each number the upper half is right
    return choose(_mm_castsi128_pd(_mm_shuffle_epi32(halves, 0xf5)), yes, no);
}
KERNEL_CODE DoubleLanes with_sign(DoubleLanes sign, DoubleLanes a)
{
    return {_mm_xor_pd(a.x, sign.x)};
}

} // namespace
} // namespace multipath
