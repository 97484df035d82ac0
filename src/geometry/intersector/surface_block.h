#pragma once

#include <cstdint>

namespace multipath {

/// Axes along which the edges of several rectangles run, in the coordinates of FilterFrame. A line's components along
/// the axes serve all of them: with a the component of the direction along the normal, h the distance from the line's
/// middle to the plane, and (d, m) the components of direction and middle along an edge, the line crosses the plane at
/// t = h / a, from its middle on, and there
///     u = (m - centre) + t d
/// is the place along the edge: the line passes through where |u| <= half, both ways. 1 / a serves all rectangles
/// across an axis. Plain data: the kernels for the instruction sets include this.
struct RectangleFrame
{
    float axis[3][3];
    std::uint32_t end[3]; ///< the rectangles across axis k are those up to end[k], one frame and axis after the other
};

/// A rectangle across axis k of its frame: u runs along axis k + 1, v along axis k + 2, in cyclic order.
struct FrameRectangle
{
    float offset; ///< along the normal axis
    float centre_u, centre_v;
    float half_u, half_v; ///< half lengths of the edges

    // What the tests need so that nothing is lost: derived in block_filling.cpp. The reciprocal 1 / |a| may be
    // wrong by the share `error`, at most 2^-11.
    static constexpr float least_approach = 1e-6f; ///< stands for a smaller |a|, per unit of FilterLine::scale
    /// Of |u| and |v|, per unit of FilterLine::scale / |a|.
    static constexpr float slack(float error) { return 1.1e-4f + 3.0f * error; }
    /// Of |t|, per unit of 1 / |a|.
    static constexpr float distance_slack(float error) { return 5e-5f + 3.0f * error; }
};

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

/// A node of the hierarchy: the boxes of up to 16 children side by side, in the coordinates of FilterFrame. Plain data.
struct alignas(64) WideNode
{
    static constexpr unsigned lanes = 16;
    static constexpr std::uint32_t leaf_flag = 0x80000000u;

    float plane[6 * lanes];     ///< low x, y, z, high x, y, z; low > high for a child that is not there
    std::uint32_t child[lanes]; ///< number of a node, or leaf_flag + number of a leaf

    static constexpr unsigned low(unsigned axis) { return axis * lanes; } ///< place of these planes
    static constexpr unsigned high(unsigned axis) { return (3 + axis) * lanes; }
};

/// Up to 16 surfaces of the hierarchy side by side: less than half as much memory as a SurfaceBlock, for what a large
/// scene waits for is its memory. Plain data.
///
/// With c from the line's middle to the corner, n = cross(u, v) and a = dot(n, direction), a line passes through where,
/// all of them times the sign of a, u a = dot(cross(c, direction), v) and v a = -dot(cross(c, direction), u) lie
/// between 0 and |a|, for a triangle u a + v a too, and meets the plane at t = dot(n, c) / a from its middle on
/// (Möller, Trumbore: Fast, minimum storage ray-triangle intersection, 1997). block_filling.cpp derives the slack.
struct alignas(64) LeafBlock
{
    static constexpr unsigned lanes = 16;

    float corner[3][lanes];
    float edge_u[3][lanes];
    float edge_v[3][lanes];
    float slack[lanes]; ///< of u a and v a, per unit of FilterLine::scale, and of t a; negative for a triangle; not a
                        ///< number for an empty lane
    std::uint32_t surface[lanes];
};

} // namespace multipath
