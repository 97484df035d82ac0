// The filters for x86-64 processors with SSE2, which all of them have: 4 surfaces at a time.

#include "geometry/intersector/kernel.h"

#if defined(__x86_64__)

#include <emmintrin.h>

#define KERNEL_CODE __attribute__((always_inline, target("sse2"))) inline
#define KERNEL_ENTRY __attribute__((target("sse2")))

namespace multipath {
namespace {

struct Lanes
{
    static constexpr unsigned width = 4;
    static constexpr float reciprocal_error = 0x1.8p-12f;
    __m128 x;

    KERNEL_CODE static Lanes load(const float* from) { return {_mm_load_ps(from)}; }
    KERNEL_CODE static Lanes all(float value) { return {_mm_set1_ps(value)}; }
    KERNEL_CODE void store(float* to) const { _mm_store_ps(to, x); }
};

KERNEL_CODE Lanes operator+(Lanes a, Lanes b)
{
    return {_mm_add_ps(a.x, b.x)};
}
KERNEL_CODE Lanes operator*(Lanes a, Lanes b)
{
    return {_mm_mul_ps(a.x, b.x)};
}
KERNEL_CODE Lanes multiply_add(Lanes a, Lanes b, Lanes c)
{
    return {_mm_add_ps(_mm_mul_ps(a.x, b.x), c.x)};
}
KERNEL_CODE Lanes absolute(Lanes a)
{
    return {_mm_andnot_ps(_mm_set1_ps(-0.0f), a.x)};
}
KERNEL_CODE Lanes larger(Lanes a, Lanes b)
{
    return {_mm_max_ps(a.x, b.x)};
}
KERNEL_CODE Lanes smaller(Lanes a, Lanes b)
{
    return {_mm_min_ps(a.x, b.x)};
}
KERNEL_CODE Lanes with_sign_of(Lanes sign, Lanes a)
{
    return {_mm_xor_ps(a.x, _mm_and_ps(sign.x, _mm_set1_ps(-0.0f)))};
}
KERNEL_CODE Lanes operator-(Lanes a, Lanes b)
{
    return {_mm_sub_ps(a.x, b.x)};
}
KERNEL_CODE Lanes reciprocal(Lanes a)
{
    return {_mm_rcp_ps(a.x)};
}

struct LaneMask
{
    __m128 x;
};

KERNEL_CODE LaneMask not_above(Lanes a, Lanes b)
{
    return {_mm_cmple_ps(a.x, b.x)};
}
KERNEL_CODE LaneMask not_above(LaneMask so_far, Lanes a, Lanes b)
{
    return {_mm_and_ps(so_far.x, _mm_cmple_ps(a.x, b.x))};
}
KERNEL_CODE LaneMask different(LaneMask so_far, Lanes a, Lanes b)
{
    return {_mm_and_ps(so_far.x, _mm_cmpneq_ps(a.x, b.x))};
}
KERNEL_CODE Lanes where(LaneMask mask, Lanes yes, Lanes no)
{
    return {_mm_or_ps(_mm_and_ps(mask.x, yes.x), _mm_andnot_ps(mask.x, no.x))};
}
KERNEL_CODE unsigned bits(LaneMask mask)
{
    return static_cast<unsigned>(_mm_movemask_ps(mask.x));
}

struct LaneMarks
{
    __m128i x;

    KERNEL_CODE LaneMarks() : x(_mm_setzero_si128()) {}
    KERNEL_CODE void mark(LaneMask mask, std::uint32_t bit)
    {
        const __m128i bits = _mm_set1_epi32(static_cast<int>(bit));
        x = _mm_or_si128(x, _mm_and_si128(_mm_castps_si128(mask.x), bits));
    }
    KERNEL_CODE void store(std::uint32_t* to) const { _mm_store_si128(reinterpret_cast<__m128i*>(to), x); }
};

} // namespace
} // namespace multipath

#include "geometry/intersector/kernels/lane_filter.inl"

#include "geometry/intersector/kernels/lane_packet.inl"

#include "geometry/intersector/kernels/row_decision.inl"

#include "geometry/intersector/kernels/lane_phases.inl"

#include "geometry/intersector/kernels/lane_tree.inl"

namespace multipath {

const FilterKernel sse2_kernel = {"sse2",    place_lines,   filter_flat,       nearest_flat,  filter_line,
                                  visit_all, visit_nearest, decide_candidates, decide_nearest};

} // namespace multipath

#endif
