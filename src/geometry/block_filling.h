#pragma once

#include "geometry/filter_line.h"
#include "geometry/surface.h"
#include "geometry/surface_block.h"
#include "geometry/surface_table.h"

namespace multipath {

/// A block none of whose lanes lets a line pass.
SurfaceBlock empty_block();

/// Puts a surface, given by its row, into a lane of a block. Triangles must be put before parallelograms.
void fill_lane(SurfaceBlock& block, unsigned lane, const SurfaceRow& row, const FilterFrame& frame);

/// How far the row may be met beside the surface it was made from, as a share of the scene's box: farther than this and
/// neither the filter's slack nor the boxes around surfaces can be relied on. Only slivers with an angle near the
/// rounding error of double precision fail.
bool can_be_filtered(const SurfaceRow& row, const Surface& surface, const FilterFrame& frame);

} // namespace multipath
