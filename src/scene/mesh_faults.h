#pragma once

#include "geometry/surface.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// Two coplanar surfaces that overlap.
struct CoincidentFaces
{
    std::uint32_t first;
    std::uint32_t second;
    bool same_side; ///< both face the same way, so that either may hide the other; false: they face opposite ways
};

struct CoincidentPairs
{
    std::vector<CoincidentFaces> pairs; ///< in the order of their surfaces
    bool complete = true;               ///< false if there may be more pairs
};

/// Finds overlapping coplanar surfaces by testing sample points of each surface; returns at most `most` pairs. If very
/// many surfaces lie close together, only a subset of them is tested.
CoincidentPairs find_coincident_faces(const Scene& scene, std::size_t most);

/// Surfaces with an open edge: no other surface has the same edge in the opposite direction. There a closed scene would
/// leak light. A long edge along several shorter ones (a T-junction) counts as open, too.
std::vector<std::uint32_t> surfaces_with_open_edges(const SurfaceList& surfaces);

} // namespace multipath
