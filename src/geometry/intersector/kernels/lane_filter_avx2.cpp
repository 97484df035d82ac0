// The filters for x86-64 processors with AVX2 and fused multiply-add: 8 surfaces at a time.

#include "geometry/intersector/kernel.h"

#if defined(__x86_64__)

#include <immintrin.h>

#define KERNEL_CODE __attribute__((always_inline, target("avx2,fma"))) inline
#define KERNEL_ENTRY __attribute__((target("avx2,fma")))

namespace multipath {
namespace {

struct Lanes
{
    static constexpr unsigned width = 8;
    static constexpr float reciprocal_error = 0x1.8p-12f;
    __m256 x;

    KERNEL_CODE static Lanes load(const float* from) { return {_mm256_load_ps(from)}; }
    KERNEL_CODE static Lanes all(float value) { return {_mm256_set1_ps(value)}; }
    KERNEL_CODE void store(float* to) const { _mm256_store_ps(to, x); }
};

KERNEL_CODE Lanes operator+(Lanes a, Lanes b)
{
    return {_mm256_add_ps(a.x, b.x)};
}
KERNEL_CODE Lanes operator*(Lanes a, Lanes b)
{
    return {_mm256_mul_ps(a.x, b.x)};
}
KERNEL_CODE Lanes multiply_add(Lanes a, Lanes b, Lanes c)
{
    return {_mm256_fmadd_ps(a.x, b.x, c.x)};
}
KERNEL_CODE Lanes absolute(Lanes a)
{
    return {_mm256_andnot_ps(_mm256_set1_ps(-0.0f), a.x)};
}
KERNEL_CODE Lanes larger(Lanes a, Lanes b)
{
    return {_mm256_max_ps(a.x, b.x)};
}
KERNEL_CODE Lanes smaller(Lanes a, Lanes b)
{
    return {_mm256_min_ps(a.x, b.x)};
}
KERNEL_CODE Lanes with_sign_of(Lanes sign, Lanes a)
{
    return {_mm256_xor_ps(a.x, _mm256_and_ps(sign.x, _mm256_set1_ps(-0.0f)))};
}
KERNEL_CODE Lanes operator-(Lanes a, Lanes b)
{
    return {_mm256_sub_ps(a.x, b.x)};
}
KERNEL_CODE Lanes reciprocal(Lanes a)
{
    return {_mm256_rcp_ps(a.x)};
}

struct LaneMask
{
    __m256 x;
};

KERNEL_CODE LaneMask not_above(Lanes a, Lanes b)
{
    return {_mm256_cmp_ps(a.x, b.x, _CMP_LE_OQ)};
}
KERNEL_CODE LaneMask not_above(LaneMask so_far, Lanes a, Lanes b)
{
    return {_mm256_and_ps(so_far.x, _mm256_cmp_ps(a.x, b.x, _CMP_LE_OQ))};
}
KERNEL_CODE LaneMask different(LaneMask so_far, Lanes a, Lanes b)
{
    return {_mm256_and_ps(so_far.x, _mm256_cmp_ps(a.x, b.x, _CMP_NEQ_OQ))};
}
KERNEL_CODE Lanes where(LaneMask mask, Lanes yes, Lanes no)
{
    return {_mm256_blendv_ps(no.x, yes.x, mask.x)};
}
KERNEL_CODE unsigned bits(LaneMask mask)
{
    return static_cast<unsigned>(_mm256_movemask_ps(mask.x));
}

struct LaneMarks
{
    __m256i x;

    KERNEL_CODE LaneMarks() : x(_mm256_setzero_si256()) {}
    KERNEL_CODE void mark(LaneMask mask, std::uint32_t bit)
    {
        const __m256i bits = _mm256_set1_epi32(static_cast<int>(bit));
        x = _mm256_or_si256(x, _mm256_and_si256(_mm256_castps_si256(mask.x), bits));
    }
    KERNEL_CODE void store(std::uint32_t* to) const { _mm256_store_si256(reinterpret_cast<__m256i*>(to), x); }
};

} // namespace
} // namespace multipath

#include "geometry/intersector/kernels/lane_filter.inl"

#include "geometry/intersector/kernels/lane_packet.inl"

#include "geometry/intersector/kernels/row_decision_avx2.inl"

#include "geometry/intersector/kernels/lane_phases.inl"

#include "geometry/intersector/kernels/lane_tree.inl"

namespace multipath {

const FilterKernel avx2_kernel = {"avx2",    place_lines,   filter_flat,       nearest_flat,  filter_line,
                                  visit_all, visit_nearest, decide_candidates, decide_nearest};

} // namespace multipath

#endif
