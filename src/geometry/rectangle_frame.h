#pragma once

#include <cstdint>

namespace multipath {

/// Axes along which the edges of several rectangles run, in the coordinates of FilterFrame. A line's components along
/// the axes serve all of them: with a the component of the direction along the normal, h the distance from the line's
/// middle to the plane, and (d, m) the components of direction and middle along an edge,
///     u a = (m - centre) a + h d,
/// u being the place along the edge, and the line passes through where |u a| <= half |a|, both ways. Plain data: the
/// kernels for the instruction sets include this.
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

    static constexpr float slack = 1e-4f;          ///< of |u a| and |v a|, per unit of FilterLine::scale
    static constexpr float distance_slack = 4e-5f; ///< of |h|
};

} // namespace multipath
