// The filters in plain C++, for any processor: one surface after the other.

#include "geometry/conditions.h"
#include "geometry/intersector/kernel.h"

#include <cmath>

#define KERNEL_CODE inline
#define KERNEL_ENTRY

namespace multipath {
namespace {

struct Lanes
{
    static constexpr unsigned width = 1;
    static constexpr float reciprocal_error = 0x1p-23f;
    float x;

    static Lanes load(const float* from) { return {*from}; }
    static Lanes all(float value) { return {value}; }
    void store(float* to) const { *to = x; }
};

KERNEL_CODE Lanes operator+(Lanes a, Lanes b)
{
    return {a.x + b.x};
}
KERNEL_CODE Lanes operator*(Lanes a, Lanes b)
{
    return {a.x * b.x};
}
KERNEL_CODE Lanes multiply_add(Lanes a, Lanes b, Lanes c)
{
    return {a.x * b.x + c.x};
}
KERNEL_CODE Lanes absolute(Lanes a)
{
    return {std::abs(a.x)};
}
KERNEL_CODE Lanes larger(Lanes a, Lanes b)
{
    return {a.x > b.x ? a.x : b.x};
}
KERNEL_CODE Lanes smaller(Lanes a, Lanes b)
{
    return {a.x < b.x ? a.x : b.x};
}
/// Minus x where the sign is negative.
KERNEL_CODE Lanes with_sign_of(Lanes sign, Lanes a)
{
    return {sign.x < 0.0f ? -a.x : a.x};
}
KERNEL_CODE Lanes operator-(Lanes a, Lanes b)
{
    return {a.x - b.x};
}
/// About 1 / a, for 1e-30 <= a <= 1e30, wrong by no more than the share Lanes::reciprocal_error.
KERNEL_CODE Lanes reciprocal(Lanes a)
{
    return {1.0f / a.x};
}

/// A truth in each lane.
struct LaneMask
{
    bool x;
};

KERNEL_CODE LaneMask not_above(Lanes a, Lanes b)
{
    return {a.x <= b.x};
}
/// What `so_far` says, and a <= b.
KERNEL_CODE LaneMask not_above(LaneMask so_far, Lanes a, Lanes b)
{
    return {every(so_far.x, a.x <= b.x)};
}
/// What `so_far` says, and a != b.
KERNEL_CODE LaneMask different(LaneMask so_far, Lanes a, Lanes b)
{
    return {every(so_far.x, a.x != b.x)};
}
KERNEL_CODE Lanes where(LaneMask mask, Lanes yes, Lanes no)
{
    return mask.x ? yes : no;
}
/// Bit i: what is true in lane i.
KERNEL_CODE unsigned bits(LaneMask mask)
{
    return mask.x ? 1u : 0u;
}

/// 32 marks in each lane.
struct LaneMarks
{
    std::uint32_t x = 0;

    /// Sets a mark (one bit) where the mask says so.
    void mark(LaneMask mask, std::uint32_t bit) { x |= mask.x ? bit : 0u; }
    void store(std::uint32_t* to) const { *to = x; }
};

} // namespace
} // namespace multipath

#include "geometry/intersector/kernels/lane_filter.inl"

#include "geometry/intersector/kernels/lane_packet.inl"

#include "geometry/intersector/kernels/row_decision.inl"

#include "geometry/intersector/kernels/lane_phases.inl"

#include "geometry/intersector/kernels/lane_tree.inl"

namespace multipath {

const FilterKernel plain_kernel = {"plain",   place_lines,   filter_flat,       nearest_flat,  filter_line,
                                   visit_all, visit_nearest, decide_candidates, decide_nearest};

} // namespace multipath
