#pragma once

#include <cstdint>

namespace multipath {

/// Three orthogonal axes that are the normals and edge directions of several rectangles, in the coordinates of
/// FilterFrame. The components of a line along the axes are computed once for all of them. Let a be the component of
/// the direction along a rectangle's normal, h the distance from the line's middle to its plane, and (d, m) the
/// components of direction and middle along one of its edges. The line crosses the plane at t = h / a, from its middle,
/// and
///     u = (m - centre) + t d
/// is the coordinate along the edge: the line meets the rectangle if |u| <= half for both edges. One reciprocal 1 / a
/// serves all rectangles across an axis. Plain data: the kernels for the instruction sets include this.
struct RectangleFrame
{
    float axis[3][3];
    std::uint32_t end[3]; ///< end of the rectangles across axis k in the list, which is sorted by frame and axis
};

/// Rectangle perpendicular to axis k of its frame: u runs along axis k + 1, v along axis k + 2, in cyclic order.
struct FrameRectangle
{
    float offset; ///< of its plane, along the normal axis
    float centre_u, centre_v;
    float half_u, half_v; ///< half lengths of the edges

    // Tolerances with which the tests lose no hit, derived in block_filling.cpp. `error` is the relative error of the
    // reciprocal 1 / |a|, at most 2^-11.
    static constexpr float least_approach = 1e-6f; ///< lower bound put in for |a|, per unit of FilterLine::scale
    /// Slack of |u| and |v|, per unit of FilterLine::scale / |a|.
    static constexpr float slack(float error) { return 1.1e-4f + 3.0f * error; }
    /// Slack of |t|, per unit of 1 / |a|.
    static constexpr float distance_slack(float error) { return 5e-5f + 3.0f * error; }
};

/// Up to 16 surfaces as a structure of arrays, in single precision and in the coordinates of FilterFrame, so that a
/// filter tests all of them at once. Plain data: the kernels for the instruction sets include this.
///
/// Let u, v run from -1 to 1 and multiply every test by the approach a = dot(normal, direction). A line passes through
/// a surface if |u a| <= |a|, |v a| <= |a| and, for a triangle, (u a + v a) sign(a) <= 0. No test needs a division, and
/// u a and v a are linear in the line's Plücker coordinates:
///     u a = dot(u_moment, moment) + dot(u_direction, direction).
/// The crossing lies between the ends of the line if |h| <= |a| half_length, h the distance of the line's middle from
/// the plane. block_filling.cpp derives the slack with which these tests lose no hit.
struct alignas(64) SurfaceBlock
{
    static constexpr unsigned lanes = 16;

    float normal[3][lanes];
    float offset[lanes];
    float u_moment[3][lanes];
    float u_direction[3][lanes];
    float v_moment[3][lanes];
    float v_direction[3][lanes];
    float slack[lanes];    ///< tolerance of |u a| and |v a|, per unit of FilterLine::scale; negative in an empty lane
    float diagonal[lanes]; ///< upper bound of (u a + v a) sign(a), likewise; no_diagonal for a parallelogram.
                           ///< Triangles have the first lanes

    static constexpr float no_diagonal = 0x1p+100f;
    static constexpr float distance_slack = 0x1p-19f; ///< tolerance of |h|
};

/// The surfaces of a small scene, which are all tested one by one. Their order is: triangles, then parallelograms, with
/// number s in lane s % 16 of block s / 16, then the rectangles that belong to frames.
struct FlatSurfaces
{
    const SurfaceBlock* blocks;
    const float* plane;  ///< plane number of each surface
    const float* number; ///< index of each surface in the scene, for the caller
    unsigned triangles;  ///< number of triangles
    unsigned others;     ///< number of triangles and parallelograms without frame
    unsigned count;      ///< number of all surfaces
    const RectangleFrame* frames;
    unsigned frame_count;
    const FrameRectangle* rectangles; ///< the surfaces from number `others` on

    static constexpr unsigned most = 512;     ///< largest number of surfaces
    static constexpr float never = 0x1p+100f; ///< value of t that means "no hit"
};

/// Node of the bounding volume hierarchy: the boxes of up to 16 children as a structure of arrays, in the coordinates
/// of FilterFrame. Plain data.
struct alignas(64) WideNode
{
    static constexpr unsigned lanes = 16;
    static constexpr std::uint32_t leaf_flag = 0x80000000u;

    float plane[6 * lanes];     ///< low x, y, z, high x, y, z; low > high in an empty lane
    std::uint32_t child[lanes]; ///< index of a node, or leaf_flag + index of a leaf

    static constexpr unsigned low(unsigned axis) { return axis * lanes; } ///< offset of the low planes
    static constexpr unsigned high(unsigned axis) { return (3 + axis) * lanes; }
};

/// Leaf of the hierarchy: up to 16 surfaces as a structure of arrays. It takes less than half the memory of a
/// SurfaceBlock, because large scenes are limited by memory access. Plain data.
///
/// The test is that of Möller and Trumbore (Fast, minimum storage ray-triangle intersection, 1997). Let u, v be the
/// edges, c the vector from the line's middle to the corner, n = cross(u, v) and a = dot(n, direction). The line passes
/// through the surface if u a = dot(cross(c, direction), v) and v a = -dot(cross(c, direction), u), for a triangle u a
/// + v a too, lie between 0 and |a| after multiplication by the sign of a. It meets the plane at t = dot(n, c) / a from
/// its middle. block_filling.cpp derives the slack.
struct alignas(64) LeafBlock
{
    static constexpr unsigned lanes = 16;

    float corner[3][lanes];
    float edge_u[3][lanes];
    float edge_v[3][lanes];
    float slack[lanes]; ///< tolerance of u a and v a, per unit of FilterLine::scale, and of t a; negated for a
                        ///< triangle; NaN in an empty lane
    std::uint32_t surface[lanes];
};

} // namespace multipath
