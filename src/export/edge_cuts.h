#pragma once

#include "export/patch_mesh.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// A place on the rim of a side where a corner of another side lies.
struct EdgeCut
{
    RimEdge edge;
    double share = 0.0;       ///< of the way along the edge, in (0, 1)
    std::uint32_t vertex = 0; ///< of the other side
};

/// The mesh with every face that has cuts replaced by triangles around its middle, which meet the other side's corners.
/// Cuts are in the order of faces, of a face's corners, and along each edge. New vertices have the values [W/m^2] of
/// where they are.
PatchMesh with_cuts(const PatchMesh& mesh, const std::vector<EdgeCut>& cuts);

} // namespace multipath
