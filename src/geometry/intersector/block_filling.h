#pragma once

#include "geometry/intersector/line_batch.h"
#include "geometry/intersector/surface_block.h"
#include "geometry/intersector/surface_table.h"
#include "geometry/surface.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// Block with the `count` surfaces whose indices are in `surfaces`, at most SurfaceBlock::lanes.
SurfaceBlock block_of(const SurfaceTable& table, const std::uint32_t* surfaces, std::size_t count,
                      const FilterFrame& frame);

/// True if the filters and the boxes around surfaces lose no hit of `surface`: the rounding errors of `row`, which was
/// made from `surface`, displace the corners by less than the slack of the filters and the margins of the boxes allow.
/// False for slivers, with an angle below about 1e-5 radian, or below 1e-3 radian if the surface is tiny or the scene
/// lies far from the origin.
bool can_be_filtered(const SurfaceRow& row, const Surface& surface, const FilterFrame& frame);

/// Rectangles grouped by the directions of their edges. Walls and furniture of a room share few directions.
struct FramedRectangles
{
    std::vector<RectangleFrame> frames;
    std::vector<FrameRectangle> rectangles; ///< sorted by frame, then by axis
    std::vector<std::uint32_t> surfaces;    ///< index of the surface of each rectangle
    std::vector<std::uint32_t> others;      ///< indices of the surfaces that are not rectangles
};

/// Sorts the surfaces of the table with these indices into rectangles and others. The time is quadratic at worst, so
/// the function is meant for few surfaces.
FramedRectangles group_by_frames(const SurfaceTable& table, const std::vector<std::uint32_t>& surfaces,
                                 const FilterFrame& frame);

} // namespace multipath
