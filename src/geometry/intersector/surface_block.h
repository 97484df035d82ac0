#pragma once

#include <cstdint>

namespace multipath {

/// Three orthogonal axes that are the normals and edge directions of several rectangles, in the coordinates of
/// FilterFrame. The components of a line along the axes are computed once for all these rectangles. Let a be the
/// component of the line's direction along the normal of a rectangle, h the signed distance from the line's middle to
/// the plane of the rectangle along this normal, and (d, m) the components of direction and middle along one edge of
/// the rectangle. The line crosses the plane at t = h / a, counted from the middle of the line, and
///     u = (m - centre) + t d
/// is the coordinate of the crossing along the edge, counted from the centre of the rectangle. The line meets the
/// rectangle if |u| <= half (half the edge length) for both edges. One reciprocal 1 / a serves all rectangles that are
/// perpendicular to the same axis. Plain data, because the kernels for all instruction sets include this file.
struct RectangleFrame
{
    float axis[3][3];     ///< axis[k]: components x, y, z of unit vector k
    std::uint32_t end[3]; ///< end[k]: one past the last rectangle normal to axis k in the list sorted by frame and axis
};

/// Rectangle perpendicular to axis k of a frame ("across axis k"): u runs along axis k + 1, v along axis k + 2, in
/// cyclic order. Lengths are in the coordinates of FilterFrame.
struct FrameRectangle
{
    float offset;             ///< coordinate of the plane along axis k
    float centre_u, centre_v; ///< coordinates of the centre along the two other axes
    float half_u, half_v;     ///< half lengths of the edges

    // Tolerances with which the tests lose no hit, derived in block_filling.cpp. `error` is the relative error of the
    // reciprocal 1 / |a| on this processor, at most 2^-11.
    static constexpr float least_approach = 1e-6f; ///< lower bound of |a| in 1 / |a|, per unit of LineBatch::scale
    /// Slack of |u| and |v|, per unit of LineBatch::scale / |a|.
    static constexpr float slack(float error) { return 1.1e-4f + 3.0f * error; }
    /// Slack of |t|, per unit of 1 / |a|.
    static constexpr float distance_slack(float error) { return 5e-5f + 3.0f * error; }
};

/// Up to 16 surfaces as a structure of arrays, in the coordinates of FilterFrame: a leaf of the hierarchy, or part of a
/// small scene. Entry `lane` of every array belongs to the same surface. Plain data.
///
/// The test is that of Möller and Trumbore (Fast, minimum storage ray-triangle intersection, 1997). Let U, V be the
/// edges, c the vector from the line's middle to the corner, n = cross(U, V) and a = dot(n, direction). The line
/// crosses the plane at t = dot(n, c) / a, counted from the middle of the line, at the coordinates u, v (from 0 to 1)
/// with
///     u a = dot(cross(c, direction), V),  v a = -dot(cross(c, direction), U).
/// The line passes through a parallelogram if u a and v a, multiplied by the sign of a, lie between 0 and |a|. For a
/// triangle, u a + v a must also lie there. block_filling.cpp derives the slack.
struct alignas(64) SurfaceBlock
{
    static constexpr unsigned lanes = 16;

    float corner[3][lanes];
    float edge_u[3][lanes];
    float edge_v[3][lanes];
    float slack[lanes]; ///< tolerance of u a and v a, per unit of LineBatch::scale, and tolerance of t a; negated for
                        ///< a triangle; NaN in an empty lane
    std::uint32_t surface[lanes]; ///< index of the surface in the SurfaceList

    /// A surface in the plane around the start of a ray has t a below this many times its tolerance; derived in
    /// block_filling.cpp.
    static constexpr float beyond_own_plane = 8.0f;
};

/// The surfaces of a small scene, which are all tested against every line. They are numbered in the order: surfaces
/// without a frame, rectangles that belong to frames.
struct FlatSurfaces
{
    const SurfaceBlock* blocks; ///< surface s without a frame has lane s % 16 of block s / 16
    const float* plane;         ///< plane[s]: plane number of surface s (see SharedPlanes)
    unsigned others;            ///< number of surfaces without a frame
    unsigned count;             ///< number of all surfaces, at most `most`
    const RectangleFrame* frames;
    unsigned frame_count;
    const FrameRectangle* rectangles; ///< surface s has the rectangle s - others; sorted by frame and axis

    static constexpr unsigned most = 512;     ///< largest number of surfaces in such a scene
    static constexpr float never = 0x1p+100f; ///< value of t that means "no hit"
};

/// Node of the bounding volume hierarchy: the boxes of up to 16 children as a structure of arrays, in the coordinates
/// of FilterFrame. Plain data.
struct alignas(64) WideNode
{
    static constexpr unsigned lanes = 16;
    static constexpr std::uint32_t leaf_flag = 0x80000000u;

    float plane[6 * lanes];     ///< six arrays: low x, y, z, high x, y, z of the boxes; low > high in an empty lane
    std::uint32_t child[lanes]; ///< index of a node, or leaf_flag + index of a leaf

    static constexpr unsigned low(unsigned axis) { return axis * lanes; } ///< offset in `plane` of the low planes
    static constexpr unsigned high(unsigned axis) { return (3 + axis) * lanes; }
};

} // namespace multipath
