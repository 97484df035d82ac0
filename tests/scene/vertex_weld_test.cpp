#include "scene/vertex_weld.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <random>
#include <vector>

namespace vertex_weld_test {

using namespace multipath;

namespace {

/// The first vertex at the same place, looked for among all.
LargeVector<std::uint32_t> welded_one_by_one(const LargeVector<Vec3>& vertices)
{
    LargeVector<std::uint32_t> first;
    for (std::uint32_t i = 0; i < vertices.size(); ++i)
        for (std::uint32_t k = 0; k <= i; ++k)
            if (vertices[k] == vertices[i]) {
                first.push_back(k);
                break;
            }
    return first;
}

} // namespace

TEST_CASE("vertices at the same place are one, whatever the grid that they stand on")
{
    std::mt19937 random(7);
    for (const std::size_t count : {0u, 1u, 7u, 8u, 9u, 500u, 1000u})
        for (const double spacing : {1.0, 0.25, 0.1, 1e-3}) {
            LargeVector<Vec3> vertices;
            for (std::size_t i = 0; i < count; ++i) {
                const auto coordinate = [&] { return spacing * (static_cast<double>(random() % 9) - 4.0); };
                vertices.push_back({coordinate(), coordinate(), coordinate()});
            }
            CHECK(weld(vertices) == welded_one_by_one(vertices));
        }
}

TEST_CASE("round coordinates, which differ in few bits, do not crowd the table")
{
    LargeVector<Vec3> pole; // a square mast, every corner twice
    for (int storey = 0; storey < 500; ++storey)
        for (const Vec3 corner : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}})
            pole.push_back({corner.x, corner.y, static_cast<double>(storey)});
    const std::size_t corners = pole.size();
    for (std::size_t i = 0; i < corners; ++i)
        pole.push_back(pole[i]);
    CHECK(weld(pole) == welded_one_by_one(pole));
}

} // namespace vertex_weld_test
