#pragma once

#include "image/corner_lattice.h"
#include "image/skin.h"
#include "image/visible_patches.h"
#include "scene/rgb.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// Patches of one side of one surface that meet at a corner and have nothing between them: they share one value there.
struct CornerGroup
{
    std::uint32_t surface = 0;
    Vec3 normal; ///< of the side
    Vec3 corner;
    std::vector<std::size_t> places; ///< CornerLattice::per_cell * patch + number of the corner
    Rgb value;
    double weight = 0.0; ///< open shares of the patches, added up
    std::vector<OpenPoint>
        points; ///< on a border, or if asked for: in the open, by turns close to the corner and to the middle
    bool on_border = false; ///< of the surface
};

/// Of the corners of one side of a surface in the rows first_row ... end_row - 1 of its lattice. A value is the mean of
/// the patches of the group; towards whatever ends the group, the border or something that stands there, the values of
/// a parallelogram continue their slope.
std::vector<CornerGroup> corner_groups(const VisiblePatches& patches, std::uint32_t surface, bool front,
                                       std::uint32_t first_row, std::uint32_t end_row, bool with_points);

} // namespace multipath
