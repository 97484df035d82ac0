#pragma once

#include "geometry/intersector/filter_line.h"
#include "geometry/intersector/surface_block.h"
#include "geometry/intersector/surface_table.h"
#include "geometry/surface.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// A block none of whose lanes lets a line pass.
SurfaceBlock empty_block();

/// Puts a surface, given by its row, into a lane of a block. Triangles must be put before parallelograms.
void fill_lane(SurfaceBlock& block, unsigned lane, const SurfaceRow& row, const FilterFrame& frame);

/// A leaf of the hierarchy with these surfaces, not more than LeafBlock::lanes.
LeafBlock leaf_of(const SurfaceTable& table, const std::uint32_t* surfaces, unsigned count, const FilterFrame& frame);

/// How far the row may be met beside the surface it was made from, as a share of the scene's box: farther than this and
/// neither the filter's slack nor the boxes around surfaces can be relied on. Only slivers with an angle near the
/// rounding error of double precision fail.
bool can_be_filtered(const SurfaceRow& row, const Surface& surface, const FilterFrame& frame);

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
