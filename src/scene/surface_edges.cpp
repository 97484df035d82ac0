#include "scene/surface_edges.h"

#include "base/disjoint_sets.h"
#include "geometry/polygon.h"
#include "scene/vertex_weld.h"

namespace multipath {

LargeVector<FaceEdge> edges_of(const SurfaceList& surfaces, const Bounds& bounds)
{
    LargeVector<Vec3> corners;
    for (const Surface& surface : surfaces)
        for (const Vec3 corner : corners_of(surface))
            corners.push_back(snapped(corner, bounds));
    const LargeVector<std::uint32_t> welded = weld(corners);
    LargeVector<FaceEdge> edges;
    auto first = welded.begin();
    for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
        const auto end = first + (surfaces[s].shape == Shape::triangle ? 3 : 4);
        std::uint32_t from = *(end - 1);
        for (; first != end; from = *first++)
            if (from != *first)
                edges.push_back({std::min(from, *first), std::max(from, *first), s, from < *first});
    }
    return edges;
}

std::vector<std::uint32_t> connected_parts(const SurfaceList& surfaces, const Bounds& bounds)
{
    DisjointSets parts(surfaces.size());
    for_each_edge(edges_of(surfaces, bounds), [&](auto begin, auto end) {
        if (end - begin == 2 && begin[0].upward != begin[1].upward)
            parts.unite(begin[0].face, begin[1].face);
    });
    return parts.roots();
}

} // namespace multipath
