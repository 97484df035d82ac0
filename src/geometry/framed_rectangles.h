#pragma once

#include "geometry/filter_line.h"
#include "geometry/rectangle_frame.h"
#include "geometry/surface_table.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Rectangles ordered by the directions of their edges: the walls and the furniture of a room have few of these.
struct FramedRectangles
{
    std::vector<RectangleFrame> frames;
    std::vector<FrameRectangle> rectangles;
    std::vector<std::uint32_t> surfaces; ///< which surfaces the rectangles are
    std::vector<std::uint32_t> others;   ///< surfaces that are no rectangles
};

/// For few surfaces: the time grows with their square.
FramedRectangles group_by_frames(const SurfaceTable& table, const std::vector<std::uint32_t>& surfaces,
                                 const FilterFrame& frame);

} // namespace multipath
