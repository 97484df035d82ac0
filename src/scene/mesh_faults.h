#pragma once

#include "geometry/surface.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// Two surfaces that share a piece of their plane.
struct CoincidentFaces
{
    std::uint32_t first;
    std::uint32_t second;
    bool same_side; ///< both face the same way, so that one hides the other at random; else they face each other
};

struct CoincidentPairs
{
    std::vector<CoincidentFaces> pairs; ///< in order of the surfaces
    bool complete = true;               ///< false if there may be more
};

/// Pairs of surfaces that overlap at one of the points sampled on each; at most `most` pairs. Of very many surfaces
/// close to each other only some are looked at.
CoincidentPairs find_coincident_faces(const Scene& scene, std::size_t most);

/// Surfaces with an edge that no other surface runs along in the opposite direction from corner to corner: where a
/// closed scene would leak. An edge that meets several shorter ones counts as open too.
std::vector<std::uint32_t> surfaces_with_open_edges(const SurfaceList& surfaces);

} // namespace multipath
