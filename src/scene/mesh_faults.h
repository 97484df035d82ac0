#pragma once

#include "geometry/surface.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// Indices of two coplanar surfaces that overlap.
struct CoincidentFaces
{
    std::uint32_t first;
    std::uint32_t second;
    /// True if both face the same way: lines then meet the smaller one, a convention of this program; false if they
    /// face opposite ways.
    bool same_side;
};

struct CoincidentPairs
{
    std::vector<CoincidentFaces> pairs; ///< first < second in each pair; sorted by first, then by second
    /// False if find_coincident_faces() found more than `most` pairs, or tested only some of the surfaces.
    bool complete = true;
};

/// Finds overlapping coplanar surfaces by testing sample points of each surface; returns at most `most` pairs. Small
/// overlaps between the sample points are missed. If very many surfaces lie close together, only some of them are
/// tested.
CoincidentPairs find_coincident_faces(const Scene& scene, std::size_t most);

/// Indices, ascending, of the surfaces with an open edge: one that no other surface has in the opposite direction.
/// Light can leak through such an edge out of a room that is meant to be closed. A long edge along several shorter ones
/// (a T-junction) counts as open. Corners are equal if they snap to the same grid point (snapped()).
std::vector<std::uint32_t> surfaces_with_open_edges(const SurfaceList& surfaces);

} // namespace multipath
