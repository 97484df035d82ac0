#include "scene/obj/parallelogram_merge.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace parallelogram_merge_test {

using namespace multipath;

namespace {

/// Triangles, each with vertices of its own as many exporters write them.
struct Triangles
{
    ObjMesh mesh;

    Triangles& add(Vec3 a, Vec3 b, Vec3 c, std::uint32_t material = 0, std::uint32_t group = 0)
    {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const Vec3 p : {a, b, c}) {
            mesh.corners.push_back({static_cast<std::uint32_t>(mesh.vertices.size())});
            mesh.vertices.push_back(p);
        }
        mesh.faces.push_back({first, 3, static_cast<std::uint32_t>(mesh.faces.size()), material, group});
        return *this;
    }
    LargeVector<Piece> merged() const
    {
        const SceneScale scale = scale_of(mesh);
        LargeVector<Piece> pieces = cut_into_pieces(mesh, scale).pieces;
        merge_triangles(pieces, mesh, scale);
        return pieces;
    }
    Vec3 at(const Piece& piece, std::size_t corner) const { return mesh.at(piece.corners[corner]); }
};

const Vec3 p0 = {0, 0, 0};
const Vec3 p1 = {2, 0, 0};
const Vec3 p2 = {2, 1, 0};
const Vec3 p3 = {0, 1, 0};

} // namespace

TEST_CASE("a quad cut along a diagonal becomes that quad again, for every order of its corners")
{
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            std::array<Vec3, 3> a = {p0, p1, p2};
            std::array<Vec3, 3> b = {p0, p2, p3};
            std::rotate(a.begin(), a.begin() + i, a.end());
            std::rotate(b.begin(), b.begin() + j, b.end());
            const Triangles triangles = Triangles().add(a[0], a[1], a[2]).add(b[0], b[1], b[2]);
            const LargeVector<Piece> pieces = triangles.merged();
            REQUIRE(pieces.size() == 1);
            const Vec3 u = triangles.at(pieces[0], 1) - triangles.at(pieces[0], 0);
            const Vec3 v = triangles.at(pieces[0], 3) - triangles.at(pieces[0], 0);
            CHECK(triangles.at(pieces[0], 0) == a[0]);
            CHECK(cross(u, v) == Vec3{0, 0, 2});
        }
}

TEST_CASE("triangles that differ in material, group, side or plane stay apart")
{
    CHECK(Triangles().add(p0, p1, p2, 0).add(p0, p2, p3, 1).merged().size() == 2);
    CHECK(Triangles().add(p0, p1, p2, 0, 0).add(p0, p2, p3, 0, 1).merged().size() == 2);
    CHECK(Triangles().add(p0, p1, p2).add(p0, p3, p2).merged().size() == 2);
    CHECK(Triangles().add(p0, p1, p2).add(p0, p2, {0, 1, 0.01}).merged().size() == 2);
    CHECK(Triangles().add(p0, p1, p2).add(p0, p2, {0.1, 1, 0}).merged().size() == 2);
}

// A meshed rectangle in any order of its triangles gives back its cells: the diagonal is the longest edge of both
// halves.
TEST_CASE("a grid of cut rectangles becomes the grid again, in any order of the triangles")
{
    struct Triple
    {
        Vec3 a, b, c;
    };
    std::vector<Triple> all;
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 9; ++j) {
            const double x = i * 0.7;
            const double y = j * 0.4;
            all.push_back({{x, y, 1}, {x + 0.7, y, 1}, {x + 0.7, y + 0.4, 1}});
            all.push_back({{x, y, 1}, {x + 0.7, y + 0.4, 1}, {x, y + 0.4, 1}});
        }
    // Computed corners of neighbours must be the same doubles.
    for (Triple& t : all)
        for (Vec3* p : {&t.a, &t.b, &t.c})
            *p = {static_cast<float>(p->x), static_cast<float>(p->y), 1};
    std::mt19937 random(3);
    for (int round = 0; round < 5; ++round) {
        Triangles triangles;
        for (const Triple& t : all)
            triangles.add(t.a, t.b, t.c);
        const LargeVector<Piece> pieces = triangles.merged();
        CHECK(pieces.size() == all.size() / 2);
        for (const Piece& piece : pieces) {
            REQUIRE_FALSE(piece.is_triangle());
            const Vec3 u = triangles.at(piece, 1) - triangles.at(piece, 0);
            const Vec3 v = triangles.at(piece, 3) - triangles.at(piece, 0);
            CHECK(std::abs(dot(u, v)) < 1e-6); // single precision
        }
        std::shuffle(all.begin(), all.end(), random);
    }
}

TEST_CASE("a slanted quad cut along its short diagonal is found too, and takes the place of its first triangle")
{
    const Vec3 a = {0, 0, 0}, b = {1, 0, 0}, c = {1.2, 1, 0}, d = {0.2, 1, 0};
    const Vec3 far = {9, 9, 9};
    const LargeVector<Piece> pieces =
        Triangles().add(far, {9, 8, 9}, {8, 9, 9}).add(a, b, d).add(far, {5, 8, 9}, {8, 6, 9}).add(b, c, d).merged();
    REQUIRE(pieces.size() == 3);
    CHECK(pieces[0].is_triangle());
    CHECK_FALSE(pieces[1].is_triangle());
    CHECK(pieces[1].face == 1);
    CHECK(pieces[2].face == 2);
}

TEST_CASE("coincident triangles do not merge with themselves or lose area")
{
    const LargeVector<Piece> pieces =
        Triangles().add(p0, p1, p2).add(p0, p1, p2).add(p0, p2, p3).add(p0, p2, p3).add(p0, p2, p1).merged();
    const auto triangle_count =
        std::count_if(pieces.begin(), pieces.end(), [](const Piece& p) { return p.is_triangle(); });
    CHECK(pieces.size() - static_cast<std::size_t>(triangle_count) == 2);
    CHECK(triangle_count == 1);
}

TEST_CASE("zero and minus zero are the same position")
{
    CHECK(Triangles().add(p0, p1, p2).add({-0.0, 0, -0.0}, {2, 1, -0.0}, p3).merged().size() == 1);
}

} // namespace parallelogram_merge_test
