#include "scene/obj/mesh_pieces.h"

#include "base/elementary.h"
#include "scene/input_problem.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <random>
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
        mesh.corners.push_back({i});
    mesh.faces.push_back({0, static_cast<std::uint32_t>(corners.size()), 9});
    return mesh;
}

MeshPieces cut(const ObjMesh& mesh)
{
    return cut_into_pieces(mesh, scale_of(mesh));
}

using Vertices = std::array<std::uint32_t, 4>;
constexpr std::uint32_t none = ObjCorner::none;

Vertices vertices_of(const Piece& piece)
{
    const std::array<ObjCorner, 4>& c = piece.corners;
    return {c[0].vertex, c[1].vertex, c[2].vertex, c[3].vertex};
}

} // namespace

TEST_CASE("a parallelogram stays whole, whatever the unit of the scene")
{
    for (const double unit : {1e-6, 1.0, 1e6}) {
        const MeshPieces pieces = cut(polygon({{0, 0, 0}, {3 * unit, 0, 0}, {4 * unit, unit, 0}, {unit, unit, 0}}));
        REQUIRE(pieces.pieces.size() == 1);
        CHECK(vertices_of(pieces.pieces[0]) == Vertices{0, 1, 2, 3});
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

// The limit is 1/1000 of the shorter side, which has the length 1.
TEST_CASE("a textured quad stays whole where its texture is a parallelogram, in both coordinates")
{
    ObjMesh mesh = polygon({{0, 0, 0}, {3, 0, 0}, {4, 1, 0}, {1, 1, 0}});
    mesh.textured = {true};
    for (ObjCorner& corner : mesh.corners)
        corner.point = corner.vertex;
    const LargeVector<TexturePoint> points = {{0.3, 0.1}, {0.9, 0.9}, {-0.3, 1.8}, {-0.9, 1.0}};
    for (const bool is_moved_far : {false, true})
        for (std::size_t corner = 0; corner < 4; ++corner)
            for (double TexturePoint::*coordinate : {&TexturePoint::s, &TexturePoint::t}) {
                CAPTURE(corner);
                mesh.texture_points = points;
                mesh.texture_points[corner].*coordinate += is_moved_far ? 0.0011 : 0.0009;
                CHECK(cut(mesh).pieces.size() == (is_moved_far ? 2 : 1));
            }
}

TEST_CASE("other quads are cut along the diagonal from the first corner, concave ones along the one inside")
{
    const MeshPieces trapezium = cut(polygon({{0, 0, 0}, {4, 0, 0}, {3, 1, 0}, {1, 1, 0}}));
    REQUIRE(trapezium.pieces.size() == 2);
    CHECK(vertices_of(trapezium.pieces[0]) == Vertices{0, 1, 2, none});
    CHECK(vertices_of(trapezium.pieces[1]) == Vertices{0, 2, 3, none});

    const MeshPieces arrow = cut(polygon({{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {1, 4, 0}}));
    REQUIRE(arrow.pieces.size() == 2);
    for (const Piece& piece : arrow.pieces)
        for (const std::uint32_t vertex : {1u, 3u}) {
            const Vertices vertices = vertices_of(piece);
            CHECK(std::count(vertices.begin(), vertices.end(), vertex) == 1);
        }
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
        CHECK(contains(cut(mesh).warnings.at(0), "a face without an area is dropped (1 in the file)"));
        mesh = polygon({{offset, 0, 0}, {offset + 1, 1, 1}, {offset + 2, 2, 2}, {offset + 1, 1, 1}, {offset, 0, 0}});
        CHECK(contains(cut(mesh).warnings.at(0), "a face without an area is dropped (1 in the file)"));
        CHECK(cut(mesh).pieces.empty());
    }
}

TEST_CASE("bent quads and polygons that cross themselves make one warning for all")
{
    ObjMesh mesh = polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}});
    mesh.faces.resize(3, mesh.faces[0]);
    const MeshPieces pieces = cut(mesh);
    CHECK(pieces.pieces.size() == 6);
    CHECK(pieces.warnings ==
          std::vector<std::string>{"a.obj:9: polygon is not planar and was cut into triangles (3 in the file)"});

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
        area += 0.5 * length(cross(round[piece.corners[1].vertex] - round[piece.corners[0].vertex],
                                   round[piece.corners[2].vertex] - round[piece.corners[0].vertex]));
    CHECK(area == doctest::Approx(count / 2.0 * std::sin(2 * pi / count)).epsilon(1e-9));
    CHECK(contains(problem_of([&] { cut(polygon(gear)); }), "a.obj:9: concave polygon of 100000 corners"));
}

} // namespace mesh_pieces_test

namespace polygon_test {

using namespace multipath;

namespace {

struct Frame
{
    Vec3 origin, u, v;
    Vec3 at(double x, double y) const { return origin + x * u + y * v; }
};

const std::vector<Frame> frames = {
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
    {{5, 6, 7}, {0, 1, 0}, {1, 0, 0}},                 // seen from the other side
    {{1000, 2000, -500}, {0.6, 0, 0.8}, {0, 1, 0}},    // far away and oblique
    {{0, 0, 0}, {0, 0, 1}, normalized({1, 0.001, 0})}, // nearly along an axis
};

double area(Vec3 a, Vec3 b, Vec3 c)
{
    return 0.5 * length(cross(b - a, c - a));
}

/// How many triangles of the cut hold the point.
int cover_count(const std::vector<Vec3>& p, const Triangulation& cut, Vec3 point, Vec3 normal)
{
    int count = 0;
    for (const auto& [a, b, c] : cut.triangles) {
        const auto left_of = [&](Vec3 from, Vec3 to) { return dot(cross(to - from, point - from), normal) > 0; };
        count += left_of(p[a], p[b]) && left_of(p[b], p[c]) && left_of(p[c], p[a]) ? 1 : 0;
    }
    return count;
}

/// Counter-clockwise signed crossings of a ray to the right, in the plane: 1 inside a simple polygon, 0 outside.
int winding_number(const std::vector<double>& x, const std::vector<double>& y, double px, double py)
{
    int winding = 0;
    for (std::size_t i = 0, j = x.size() - 1; i < x.size(); j = i++) {
        if ((y[j] <= py) == (y[i] <= py))
            continue;
        const double crossing = x[j] + (py - y[j]) / (y[i] - y[j]) * (x[i] - x[j]);
        if (crossing > px)
            winding += y[i] > y[j] ? 1 : -1;
    }
    return winding;
}

/// Cuts the polygon in every frame, and compares it at random points with the winding number.
void check_cut(const std::vector<double>& x, const std::vector<double>& y, double radius, std::mt19937_64& random)
{
    std::uniform_real_distribution<double> coordinate(-radius, radius);
    for (const Frame& frame : frames) {
        std::vector<Vec3> corners;
        for (std::size_t i = 0; i < x.size(); ++i)
            corners.push_back(frame.at(x[i], y[i]));
        const Vec3 whole = area_vector(corners);
        const Triangulation cut = clip_ears(corners, whole, 1e-14);
        CHECK_FALSE(cut.crosses_itself);
        double sum = 0.0;
        for (const auto& [a, b, c] : cut.triangles)
            sum += area(corners[a], corners[b], corners[c]);
        CHECK(sum == doctest::Approx(length(whole)).epsilon(1e-9)); // corners 2000 from the origin: 1e-13 of the scene
        for (int i = 0; i < 20; ++i) {
            const double px = coordinate(random);
            const double py = coordinate(random);
            CHECK(cover_count(corners, cut, frame.at(px, py), whole) == winding_number(x, y, px, py));
        }
    }
}

} // namespace

// A polygon is simple if its corners go once around a point inside; their distances may be anything.
TEST_CASE("triangles of a star-shaped polygon cover its inside once and its outside never")
{
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> distance(0.05, 1.0);
    for (int count = 4; count < 60; count += 3) {
        std::vector<double> x, y;
        for (int i = 0; i < count; ++i) {
            const double angle = 2.0 * std::acos(-1.0) * i / count;
            const double r = distance(random);
            x.push_back(r * std::cos(angle));
            y.push_back(r * std::sin(angle));
        }
        check_cut(x, y, 1.0, random);
    }
}

TEST_CASE("combs, spirals and polygons with straight or repeated corners are cut without overlap")
{
    std::mt19937_64 random(8);
    std::vector<double> x, y; // a comb: every second corner is reflex
    for (int i = 0; i < 20; ++i) {
        x.insert(x.end(), {i * 0.1, i * 0.1 + 0.05});
        y.insert(y.end(), {0.0, -0.9});
    }
    x.insert(x.end(), {2.0, 0.0});
    y.insert(y.end(), {0.1, 0.1});
    check_cut(x, y, 2.0, random);

    x.clear();
    y.clear();
    for (int i = 0; i <= 100; ++i) { // a spiral of five turns, out and back
        x.push_back((1 + 0.1 * i) * std::cos(0.3 * i));
        y.push_back((1 + 0.1 * i) * std::sin(0.3 * i));
    }
    for (int i = 100; i >= 0; --i) {
        x.push_back((0.5 + 0.1 * i) * std::cos(0.3 * i));
        y.push_back((0.5 + 0.1 * i) * std::sin(0.3 * i));
    }
    check_cut(x, y, 11.0, random);

    check_cut({0, 1, 2, 2, 2, 1, 1, 1, 0, 0, 0}, {0, 0, 0, 1, 2, 2, 1, 1, 1, 1, 0.5}, 2.0, random);
}

// A square with a square hole, joined by a cut that the outline runs along twice.
TEST_CASE("a hole joined to the outline stays a hole")
{
    std::mt19937_64 random(9);
    check_cut({0, 4, 4, 0, 0, 1, 1, 3, 3, 1, 0}, {0, 0, 4, 4, 1, 1, 3, 3, 1, 1, 1}, 4.0, random);
    check_cut({0, 4, 4, 0, 0, 1, 1, 3, 3, 1}, {0, 0, 4, 4, 0, 1, 3, 3, 1, 1}, 4.0, random);
}

TEST_CASE("a polygon that crosses itself is reported, and cut all the same")
{
    const std::vector<Vec3> bow = {{0, 0, 0}, {3, 3, 0}, {3, 0, 0}, {0, 1, 0}};
    const Triangulation cut = clip_ears(bow, area_vector(bow), 1e-14);
    CHECK(cut.crosses_itself);
    CHECK(cut.triangles.size() == 2);
}

TEST_CASE("the area vector is area times normal, and the distance from the plane is in scene units")
{
    const std::vector<Vec3> square = {{1, 1, 2}, {1, 3, 2}, {1, 3, 5}, {1, 1, 5}};
    CHECK(area_vector(square) == Vec3{6, 0, 0});
    CHECK(distance_from_plane(square, area_vector(square)) == 0.0);
    CHECK(reflex_corner_count(square, area_vector(square)) == 0);
    // Corners in turn 0.1 above and below the plane z = 0.
    const std::vector<Vec3> saddle = {{0, 0, 0.1}, {1, 0, -0.1}, {1, 1, 0.1}, {0, 1, -0.1}};
    CHECK(distance_from_plane(saddle, area_vector(saddle)) == doctest::Approx(0.1));
}

} // namespace polygon_test
