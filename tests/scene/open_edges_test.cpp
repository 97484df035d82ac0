#include "scene/open_edges.h"

#include "test_scenes.h"

#include <doctest/doctest.h>

namespace open_edges_test {

using namespace multipath;

TEST_CASE("a closed room has no open edge, a room without one wall has four")
{
    SceneBuilder closed;
    const std::uint32_t grey = closed.grey(0.5, 1.0);
    closed.room({0, 0, 0}, {1, 2, 3}, grey).box({0.2, 0.2, 0.2}, {0.5, 0.5, 0.5}, grey);
    std::vector<Surface> surfaces = closed.file().surfaces;
    CHECK(surfaces_with_open_edges(surfaces).empty());

    surfaces.erase(surfaces.begin()); // the floor
    CHECK(surfaces_with_open_edges(surfaces) == std::vector<std::uint32_t>{1, 2, 3, 4});
}

TEST_CASE("triangles are closed by triangles that run along their edges the other way")
{
    const Vec3 p = {0, 0, 0}, q = {1, 0, 0}, r = {0, 1, 0}, s = {0, 0, 1};
    const auto face = [](Vec3 a, Vec3 b, Vec3 c) { return Surface{Shape::triangle, a, b - a, c - a}; };
    CHECK(surfaces_with_open_edges({face(p, r, q), face(p, q, s), face(q, r, s), face(p, s, r)}).empty());
    CHECK(surfaces_with_open_edges({face(p, r, q), face(p, q, s), face(q, r, s), face(p, r, s)}).size() == 4);
}

} // namespace open_edges_test
