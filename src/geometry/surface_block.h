#pragma once

#include "geometry/rectangle_frame.h"

namespace multipath {

/// Up to 16 surfaces side by side, in single precision and in the coordinates of FilterFrame, in the form in which a
/// filter tests all of them at once. Plain data: the kernels for the instruction sets include this.
///
/// With u, v measured from -1 to 1 and every test multiplied by the approach a = dot(normal, direction), a line passes
/// through a surface where |u a| <= |a|, |v a| <= |a| and, for a triangle, (u a + v a) sign(a) <= 0. None of it needs a
/// division, and u a and v a are linear in the line's Plücker coordinates:
///     u a = dot(u_moment, moment) + dot(u_direction, direction).
/// The crossing lies within the ends of the line where |h| <= |a| half_length, h the distance of the line's middle from
/// the plane. block_filling.cpp derives how much slack these tests need to lose nothing.
struct alignas(64) SurfaceBlock
{
    static constexpr unsigned lanes = 16;

    float normal[3][lanes];
    float offset[lanes];
    float u_moment[3][lanes];
    float u_direction[3][lanes];
    float v_moment[3][lanes];
    float v_direction[3][lanes];
    float slack[lanes];    ///< of |u a| and |v a|, per unit of FilterLine::scale; very negative for an empty lane
    float diagonal[lanes]; ///< the limit of (u a + v a) sign(a), likewise; no_diagonal for a parallelogram
                           ///< (triangles have the first lanes)

    static constexpr float no_diagonal = 0x1p+100f;
    static constexpr float distance_slack = 0x1p-19f; ///< of |h|
};

/// Few surfaces, all of which are tested one after the other: first triangles, then parallelograms, number s in lane
/// s % 16 of block s / 16; then the rectangles of frames.
struct FlatSurfaces
{
    const SurfaceBlock* blocks;
    const float* plane;  ///< number of each surface's plane
    const float* number; ///< of each surface among all, for the caller
    unsigned triangles;
    unsigned others; ///< triangles and parallelograms
    unsigned count;
    const RectangleFrame* frames;
    unsigned frame_count;
    const FrameRectangle* rectangles; ///< from number `others` on

    static constexpr unsigned most = 512;
    static constexpr float never = 0x1p+100f; ///< stands for where nothing is met
};

} // namespace multipath
