#include "scene/surface_edges.h"

#include "scene/scene_builder.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

namespace surface_edges_test {

using namespace multipath;

TEST_CASE("a part is what hangs together by edges of two surfaces; a third surface at an edge is a part of its own")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    builder.room({0, 0, 0}, {1, 1, 1}, grey).rectangle({0, 0, 0}, {1, 0, 0}, {0, 0.5, 0.5}, grey);
    builder.triangle({0.2, 0.2, 0.2}, {0.4, 0.2, 0.2}, {0.2, 0.4, 0.2}, grey);
    const SurfaceList surfaces = builder.file().surfaces;
    Bounds bounds;
    for (const Surface& surface : surfaces)
        bounds.include(surface.bounds());
    // The rectangle is at the edge of the floor and the wall of low z, which hang together by the other walls.
    CHECK(connected_parts(surfaces, bounds) == std::vector<std::uint32_t>{0, 0, 0, 0, 0, 0, 6, 7});
}

TEST_CASE("sides without length are left out, and sides of the same corners are seen together")
{
    // Two triangles of different sides; the third corner of the first is at its second.
    Bounds bounds;
    bounds.include(Vec3{0, 0, 0});
    bounds.include(Vec3{1, 1, 1});
    const LargeVector<FaceEdge> edges = edges_of(
        {{Shape::triangle, {1, 0, 0}, {-1, 0, 0}, {-1, 1e-12, 0}}, {Shape::triangle, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
        bounds);
    REQUIRE(edges.size() == 5);
    std::vector<std::vector<std::uint32_t>> faces;
    for_each_edge(edges, [&](auto begin, auto end) {
        faces.emplace_back();
        for (auto side = begin; side != end; ++side)
            faces.back().push_back(side->face);
    });
    REQUIRE(faces.size() == 3);
    CHECK(faces[0].size() == 3); // there and back, and once more
    CHECK(faces[1] == std::vector<std::uint32_t>{1});
    CHECK(faces[2] == std::vector<std::uint32_t>{1});
}

} // namespace surface_edges_test
