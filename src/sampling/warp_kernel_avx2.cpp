// The maps for x86-64 processors with AVX2: 4 points at a time.

#include "sampling/warp_kernels.h"

#if defined(__x86_64__)

#include <immintrin.h>

#define KERNEL_CODE __attribute__((always_inline, target("avx2"))) inline
#define KERNEL_ENTRY __attribute__((target("avx2")))

namespace multipath {
namespace {

struct Lanes
{
    static constexpr std::size_t width = 4;
    __m256d x;

    KERNEL_CODE static Lanes load(const double* from) { return {_mm256_load_pd(from)}; }
    KERNEL_CODE static Lanes all(double value) { return {_mm256_set1_pd(value)}; }
    KERNEL_CODE void store(double* to) const { _mm256_store_pd(to, x); }
};

KERNEL_CODE Lanes operator+(Lanes a, Lanes b)
{
    return {_mm256_add_pd(a.x, b.x)};
}
KERNEL_CODE Lanes operator-(Lanes a, Lanes b)
{
    return {_mm256_sub_pd(a.x, b.x)};
}
KERNEL_CODE Lanes operator*(Lanes a, Lanes b)
{
    return {_mm256_mul_pd(a.x, b.x)};
}
KERNEL_CODE Lanes square_root(Lanes a)
{
    return {_mm256_sqrt_pd(a.x)};
}
KERNEL_CODE Lanes choose_less(Lanes a, Lanes b, Lanes yes, Lanes no)
{
    return {_mm256_blendv_pd(no.x, yes.x, _mm256_cmp_pd(a.x, b.x, _CMP_LT_OQ))};
}
template <int bit>
KERNEL_CODE Lanes sign_from_bit(Lanes a)
{
    const __m256i top = _mm256_slli_epi64(_mm256_castpd_si256(a.x), 63 - bit);
    return {_mm256_and_pd(_mm256_castsi256_pd(top), _mm256_set1_pd(-0.0))};
}
KERNEL_CODE Lanes choose_by_sign(Lanes sign, Lanes yes, Lanes no)
{
    return {_mm256_blendv_pd(no.x, yes.x, sign.x)};
}
KERNEL_CODE Lanes with_sign(Lanes sign, Lanes a)
{
    return {_mm256_xor_pd(a.x, sign.x)};
}

} // namespace
} // namespace multipath

#include "sampling/lane_warp.inl"

namespace multipath {

const WarpKernel avx2_warp_kernel = {"avx2", uniform_sphere, cosine_hemisphere};

} // namespace multipath

#endif
