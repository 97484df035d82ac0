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

    // What the tests need so that nothing is lost: derived in framed_rectangles.cpp. The reciprocal 1 / |a| may be
    // wrong by the share `error`, at most 2^-11.
    static constexpr float least_approach = 1e-6f; ///< stands for a smaller |a|, per unit of FilterLine::scale
    /// Of |u| and |v|, per unit of FilterLine::scale / |a|.
    static constexpr float slack(float error) { return 1.1e-4f + 3.0f * error; }
    /// Of |t|, per unit of 1 / |a|.
    static constexpr float distance_slack(float error) { return 5e-5f + 3.0f * error; }
};

} // namespace multipath
