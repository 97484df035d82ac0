#include "scene/obj/mesh_pieces.h"

#include "geometry/pi.h"
#include "scene/input_problem.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace mesh_pieces_test {

using namespace multipath;

namespace {

/// A mesh of one polygon.
ObjMesh polygon(const LargeVector<Vec3>& corners)
{
    ObjMesh mesh;
    mesh.path = "a.obj";
    mesh.vertices = corners;
    for (std::uint32_t i = 0; i < corners.size(); ++i)
        mesh.corners.push_back(i);
    mesh.faces.push_back({static_cast<std::uint32_t>(corners.size()), 9, 0, 0});
    return mesh;
}

MeshPieces cut(const ObjMesh& mesh)
{
    return cut_into_pieces(mesh, scale_of(mesh));
}

using Corners = std::array<std::uint32_t, 4>;
constexpr std::uint32_t none = Piece::no_vertex;

} // namespace

TEST_CASE("a parallelogram stays whole, whatever the unit of the scene")
{
    for (const double unit : {1e-6, 1.0, 1e6}) {
        const MeshPieces pieces = cut(polygon({{0, 0, 0}, {3 * unit, 0, 0}, {4 * unit, unit, 0}, {unit, unit, 0}}));
        REQUIRE(pieces.pieces.size() == 1);
        CHECK(pieces.pieces[0].corners == Corners{0, 1, 2, 3});
    }
}

// The limits are 2e-6 of the scene (here 4 long) and 1/1000 of the shorter side.
TEST_CASE("a quad is a parallelogram up to the width of a crack")
{
    const SceneScale scale = {4.0};
    const auto with_gap = [&](double side, double gap) {
        return is_parallelogram({0, 0, 0}, {4, 0, 0}, {4 + gap, side, 0}, {0, side, 0}, scale);
    };
    CHECK(with_gap(1.0, 7.9e-6));
    CHECK_FALSE(with_gap(1.0, 8.1e-6));
    CHECK(with_gap(1e-3, 0.9e-6));
    CHECK_FALSE(with_gap(1e-3, 1.1e-6));
}

TEST_CASE("other quads are cut along the diagonal from the first corner, concave ones along the one inside")
{
    const MeshPieces trapezium = cut(polygon({{0, 0, 0}, {4, 0, 0}, {3, 1, 0}, {1, 1, 0}}));
    REQUIRE(trapezium.pieces.size() == 2);
    CHECK(trapezium.pieces[0].corners == Corners{0, 1, 2, none});
    CHECK(trapezium.pieces[1].corners == Corners{0, 2, 3, none});

    const MeshPieces arrow = cut(polygon({{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {1, 4, 0}}));
    REQUIRE(arrow.pieces.size() == 2);
    for (const Piece& piece : arrow.pieces)
        for (const std::uint32_t corner : {1u, 3u})
            CHECK(std::count(piece.corners.begin(), piece.corners.end(), corner) == 1);
}

TEST_CASE("corners on straight sides, repeated corners and spikes do not count")
{
    const MeshPieces rectangle = cut(
        polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 0, 0}, {2, 1, 0}, {3, 1, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0.5, 0}}));
    REQUIRE(rectangle.pieces.size() == 1);
    CHECK_FALSE(rectangle.pieces[0].is_triangle());
}

TEST_CASE("faces without area are dropped and counted, at any distance from the origin")
{
    for (const double offset : {0.0, 1000.0}) {
        ObjMesh mesh = polygon({{offset, 0, 0}, {offset + 1, 1, 1}, {offset + 2, 2, 2}});
        CHECK(cut(mesh).zero_area_faces == 1);
        mesh = polygon({{offset, 0, 0}, {offset + 1, 1, 1}, {offset + 2, 2, 2}, {offset + 1, 1, 1}, {offset, 0, 0}});
        CHECK(cut(mesh).zero_area_faces == 1);
        CHECK(cut(mesh).pieces.empty());
    }
}

TEST_CASE("bent quads and polygons that cross themselves make one warning for all")
{
    ObjMesh mesh = polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}});
    mesh.faces.resize(3, mesh.faces[0]);
    const LargeVector<std::uint32_t> corners = mesh.corners;
    mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
    mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
    const MeshPieces pieces = cut(mesh);
    CHECK(pieces.pieces.size() == 6);
    CHECK(pieces.warnings ==
          std::vector<std::string>{"a.obj:9: polygon is not planar and was cut into triangles (and 2 more)"});

    // One corner h above a unit square lies h / 4 off the mean plane, h / 4 / sqrt(2) of the size.
    CHECK(cut(polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 7e-4}, {0, 1, 0}})).warnings.size() == 1);
    CHECK(cut(polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 4e-4}, {0, 1, 0}})).warnings.empty());

    // Here the two lobes even have the same area.
    const MeshPieces bow = cut(polygon({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}));
    CHECK(bow.pieces.size() == 2);
    REQUIRE(bow.warnings.size() == 1);
    CHECK(contains(bow.warnings[0], "a.obj:9: polygon crosses itself"));
}

// Area of the regular polygon of n corners: n/2 sin(2 pi / n).
TEST_CASE("a convex polygon may have any number of corners, a concave one not so many")
{
    const int count = 100000;
    LargeVector<Vec3> round, gear;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * pi * i / count;
        const double radius = i % 2 == 0 ? 1.0 : 0.9;
        round.push_back({std::cos(angle), std::sin(angle), 0});
        gear.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    }
    double area = 0.0;
    const MeshPieces pieces = cut(polygon(round));
    for (const Piece& piece : pieces.pieces)
        area += 0.5 * length(cross(round[piece.corners[1]] - round[piece.corners[0]],
                                   round[piece.corners[2]] - round[piece.corners[0]]));
    CHECK(area == doctest::Approx(count / 2.0 * std::sin(2 * pi / count)).epsilon(1e-9));
    CHECK(contains(problem_of([&] { cut(polygon(gear)); }), "a.obj:9: concave polygon of 100000 corners"));
}

} // namespace mesh_pieces_test
