#pragma once

#include "base/memory.h"
#include "geometry/bounds.h"
#include "geometry/surface.h"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

namespace multipath {

/// A side of a face, between two corners with the numbers that weld() gives them.
struct FaceEdge
{
    std::uint32_t low, high; ///< the numbers of the corners; low < high
    std::uint32_t face;
    bool upward; ///< the face, counter-clockwise, goes from `low` to `high`
};

/// The sides of all surfaces, except those without length. Corners are snapped() and welded.
LargeVector<FaceEdge> edges_of(const SurfaceList& surfaces, const Bounds& bounds);

/// Calls see(begin, end) with the sides that lie between the same two corners, for all such pairs of corners.
template <class See>
void for_each_edge(LargeVector<FaceEdge> edges, const See& see)
{
    std::sort(edges.begin(), edges.end(),
              [](const FaceEdge& a, const FaceEdge& b) { return std::tie(a.low, a.high) < std::tie(b.low, b.high); });
    for (auto begin = edges.cbegin(), end = begin; begin != edges.cend(); begin = end) {
        while (end != edges.cend() && end->low == begin->low && end->high == begin->high)
            ++end;
        see(begin, end);
    }
}

/// The connected parts of a scene: for each surface the index of the first surface of its part. Surfaces are connected
/// if exactly two of them have an edge, in opposite directions. An object that touches a wall either shares no edge
/// with it or is a third surface at an edge, so it is not connected to the wall.
std::vector<std::uint32_t> connected_parts(const SurfaceList& surfaces, const Bounds& bounds);

} // namespace multipath
