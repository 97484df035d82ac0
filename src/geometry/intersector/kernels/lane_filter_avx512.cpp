// The filters for x86-64 processors with AVX-512: 16 surfaces at a time.

#include "geometry/intersector/kernel.h"

#if defined(__x86_64__)

#include <immintrin.h>

#define KERNEL_CODE __attribute__((always_inline, target("avx512f"))) inline
#define KERNEL_ENTRY __attribute__((target("avx512f")))

namespace multipath {
namespace {

struct Lanes
{
    static constexpr unsigned width = 16;
    static constexpr float reciprocal_error = 0x1p-14f;
    __m512 x;

    KERNEL_CODE static Lanes load(const float* from) { return {_mm512_load_ps(from)}; }
    KERNEL_CODE static Lanes all(float value) { return {_mm512_set1_ps(value)}; }
    KERNEL_CODE void store(float* to) const { _mm512_store_ps(to, x); }
};

KERNEL_CODE Lanes operator+(Lanes a, Lanes b)
{
    return {_mm512_add_ps(a.x, b.x)};
}
KERNEL_CODE Lanes operator*(Lanes a, Lanes b)
{
    return {_mm512_mul_ps(a.x, b.x)};
}
KERNEL_CODE Lanes multiply_add(Lanes a, Lanes b, Lanes c)
{
    return {_mm512_fmadd_ps(a.x, b.x, c.x)};
}
KERNEL_CODE Lanes absolute(Lanes a)
{
    return {_mm512_abs_ps(a.x)};
}
KERNEL_CODE Lanes larger(Lanes a, Lanes b)
{
    return {_mm512_maskz_max_ps(0xffff, a.x, b.x)};
}
KERNEL_CODE Lanes smaller(Lanes a, Lanes b)
{
    return {_mm512_maskz_min_ps(0xffff, a.x, b.x)};
}
KERNEL_CODE Lanes with_sign_of(Lanes sign, Lanes a)
{
    const __m512i minus = _mm512_and_epi32(_mm512_castps_si512(sign.x), _mm512_set1_epi32(-0x7fffffff - 1));
    return {_mm512_castsi512_ps(_mm512_xor_epi32(_mm512_castps_si512(a.x), minus))};
}
KERNEL_CODE Lanes operator-(Lanes a, Lanes b)
{
    return {_mm512_sub_ps(a.x, b.x)};
}
KERNEL_CODE Lanes reciprocal(Lanes a)
{
    return {_mm512_maskz_rcp14_ps(0xffff, a.x)};
}

struct LaneMask
{
    __mmask16 x;
};

KERNEL_CODE LaneMask not_above(Lanes a, Lanes b)
{
    return {_mm512_cmp_ps_mask(a.x, b.x, _CMP_LE_OQ)};
}
KERNEL_CODE LaneMask not_above(LaneMask so_far, Lanes a, Lanes b)
{
    return {_mm512_mask_cmp_ps_mask(so_far.x, a.x, b.x, _CMP_LE_OQ)};
}
KERNEL_CODE LaneMask different(LaneMask so_far, Lanes a, Lanes b)
{
    return {_mm512_mask_cmp_ps_mask(so_far.x, a.x, b.x, _CMP_NEQ_OQ)};
}
KERNEL_CODE Lanes where(LaneMask mask, Lanes yes, Lanes no)
{
    return {_mm512_mask_mov_ps(no.x, mask.x, yes.x)};
}
KERNEL_CODE unsigned bits(LaneMask mask)
{
    return mask.x;
}

struct LaneMarks
{
    __m512i x;

    KERNEL_CODE LaneMarks() : x(_mm512_setzero_si512()) {}
    KERNEL_CODE void mark(LaneMask mask, std::uint32_t bit)
    {
        x = _mm512_mask_or_epi32(x, mask.x, x, _mm512_set1_epi32(static_cast<int>(bit)));
    }
    KERNEL_CODE void store(std::uint32_t* to) const { _mm512_store_si512(to, x); }
};

} // namespace
} // namespace multipath

#include "geometry/intersector/kernels/lane_filter.inl"

#include "geometry/intersector/kernels/lane_packet.inl"

#include "geometry/intersector/kernels/row_decision_avx2.inl"

#include "geometry/intersector/kernels/lane_phases.inl"

#include "geometry/intersector/kernels/lane_tree.inl"

namespace multipath {

const FilterKernel avx512_kernel = {"avx512",  place_lines,   filter_flat,       nearest_flat,  filter_line,
                                    visit_all, visit_nearest, decide_candidates, decide_nearest};

} // namespace multipath

#endif
