#pragma once

#include "geometry/intersector/filter_line.h"
#include "geometry/intersector/surface_block.h"
#include "geometry/intersector/surface_table.h"
#include "geometry/surface.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Block with empty lanes only: no line passes any of its tests.
SurfaceBlock empty_block();

/// Stores the surface of a row in one lane of a block. Triangles must have lower lanes than parallelograms.
void fill_lane(SurfaceBlock& block, unsigned lane, const SurfaceRow& row, const FilterFrame& frame);

/// Leaf of the hierarchy with `count` surfaces, at most LeafBlock::lanes.
LeafBlock leaf_of(const SurfaceTable& table, const std::uint32_t* surfaces, unsigned count, const FilterFrame& frame);

/// True if a line can hit the row only so close to the surface it was made from that the filter's slack and the boxes
/// around surfaces cover the error. False only for slivers with an angle near the rounding error of double precision.
bool can_be_filtered(const SurfaceRow& row, const Surface& surface, const FilterFrame& frame);

/// Rectangles grouped by the directions of their edges. Walls and furniture of a room share few directions.
struct FramedRectangles
{
    std::vector<RectangleFrame> frames;
    std::vector<FrameRectangle> rectangles;
    std::vector<std::uint32_t> surfaces; ///< surface index of each rectangle
    std::vector<std::uint32_t> others;   ///< surfaces that are not rectangles
};

/// Sorts the surfaces into rectangles and others. Takes quadratic time, so it is meant for few surfaces.
FramedRectangles group_by_frames(const SurfaceTable& table, const std::vector<std::uint32_t>& surfaces,
                                 const FilterFrame& frame);

} // namespace multipath
