#include "base/errors.h"
#include "scene/tessellation.h"
#include "test_scenes.h"

#include <cmath>
#include <doctest/doctest.h>
#include <memory>
#include <vector>

namespace tessellation_test {

using namespace multipath;

TEST_CASE("cells along an edge are edge / patch size rounded up, but not for rounding errors")
{
    const Surface surface = {Shape::parallelogram, {0, 0, 0}, {1.0, 0, 0}, {0, 0.2000000001, 0}};
    CHECK(tessellate(surface, 0.1).cells_u == 10);
    CHECK(tessellate(surface, 0.1).cells_v == 2);
    CHECK(tessellate(surface, 0.3).cells_u == 4);
    CHECK(tessellate(surface, 5.0).cell_count() == 1);
    const Surface triangle = {Shape::triangle, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    CHECK(tessellate(triangle, 0.5).cell_count() == 9); // longest edge: sqrt 2
    CHECK_THROWS_AS(tessellate(surface, 1e-6), InputError);
}

TEST_CASE("cells are counted without being made, however many there would be")
{
    const SurfaceList surfaces = {{Shape::parallelogram, {0, 0, 0}, {1, 0, 0}, {0, 2, 0}},
                                  {Shape::triangle, {0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}}};
    const double size = 0.1;
    CHECK(cell_count(surfaces, size) ==
          static_cast<double>(tessellate(surfaces[0], size).cell_count() + tessellate(surfaces[1], size).cell_count()));
    CHECK(cell_count(surfaces, 1e-12) == doctest::Approx(2e24 + 1.25e24)); // the triangle by its longest edge, squared
    CHECK(cell_count(surfaces, 1e-300) > 1e300);
}

// The centre of every cell is in that cell, and the cells tile the surface without turning over.
namespace {

/// The grid with some of its cells cut, down to level 3.
Tessellation with_trees(Tessellation grid)
{
    std::vector<std::uint8_t> levels;
    for (std::uint32_t cell = 0; cell < grid.cell_count(); ++cell)
        if (cell % 2 == 0)
            levels.insert(levels.end(), {1, 2, 3, 3, 3, 3, 2, 2, 1, 1});
        else
            levels.push_back(0);
    grid.trees = std::make_shared<const CellTrees>(grid, levels.data(), levels.size());
    return grid;
}

} // namespace

TEST_CASE("cell numbers and cells belong together, and the cells' areas add up")
{
    const Surface parallelogram = {Shape::parallelogram, {1, 2, 3}, {1, 0.5, 0}, {0.2, 0, 2}};
    const Surface triangle = {Shape::triangle, {1, 2, 3}, {1, 0.5, 0}, {0.2, 0, 2}};
    for (const Surface& surface : {parallelogram, triangle})
        for (const double size : {3.0, 0.5, 0.11, 0.03, -0.3}) { // below 0: with trees
            const Tessellation tessellation =
                size > 0.0 ? tessellate(surface, size) : with_trees(tessellate(surface, -size));
            double area = 0.0;
            for (std::uint32_t cell = 0; cell < tessellation.cell_count(); ++cell) {
                const Surface piece = tessellation.cell(surface, cell);
                area += piece.area();
                REQUIRE(dot(piece.normal(), surface.normal()) > 0.999);
                // (u, v) of the centre by solving centre - origin = u edge_u + v edge_v in the plane
                const Vec3 r = piece.centre() - surface.origin;
                const Vec3 n = cross(surface.edge_u, surface.edge_v);
                const double u = dot(cross(r, surface.edge_v), n) / dot(n, n);
                const double v = dot(cross(surface.edge_u, r), n) / dot(n, n);
                REQUIRE(tessellation.cell_at(u, v) == cell);
            }
            CHECK(area == doctest::Approx(surface.area()).epsilon(1e-12));
        }
}

TEST_CASE("a cell lies between its corners on the grid")
{
    for (const bool trees : {false, true})
        for (const Shape shape : {Shape::parallelogram, Shape::triangle}) {
            const Surface surface = {shape, {1, 2, 3}, {1, 0.5, 0}, {0.2, 0, 2}};
            const Tessellation grid = tessellate(surface, 0.3);
            const Tessellation tessellation = trees ? with_trees(grid) : grid;
            for (std::uint32_t cell = 0; cell < tessellation.cell_count(); ++cell) {
                const Surface piece = tessellation.cell(surface, cell);
                std::vector<Vec3> around = {piece.origin, piece.at(1, 0), piece.at(1, 1), piece.at(0, 1)};
                if (shape == Shape::triangle)
                    around.erase(around.begin() + 2);
                const CellCorners corners = tessellation.corners(cell);
                REQUIRE(corners.count == around.size());
                for (std::size_t k = 0; k < corners.count; ++k) {
                    const double u = static_cast<double>(corners.points[k].i) / tessellation.grid_u();
                    const double v = static_cast<double>(corners.points[k].j) / tessellation.grid_v();
                    REQUIRE(length(surface.at(u, v) - around[k]) < 1e-14); // rounding
                }
            }
        }
}

TEST_CASE("points on or just beyond the border fall into cells at the border")
{
    const Tessellation grid{Shape::parallelogram, 3, 4, nullptr};
    CHECK(grid.cell_at(-1e-17, 0.0) == 0);
    CHECK(grid.cell_at(1.0, 1.0 + 1e-16) == 11);
    const Tessellation triangles{Shape::triangle, 3, 3, nullptr};
    for (const double u : {0.0, 1.0 / 3, 0.5, 2.0 / 3, 0.9, 1.0})
        for (const double beyond : {0.0, 1e-16, 1e-15})
            CHECK(triangles.cell_at(u, 1.0 - u + beyond) < 9);
    CHECK(triangles.cell_at(1.0, 0.0) == 8);
    CHECK(triangles.cell_at(0.0, 1.0) == 4);
}

TEST_CASE("the default patch size is a round number that gives some thousand patches")
{
    for (const double edge : {1e-3, 0.5, 1.0, 3.0, 6.4, 700.0}) {
        SceneBuilder builder;
        const SceneFile file = builder.room({0, 0, 0}, {edge, edge, edge}, builder.grey(0.5, 1.0)).file();
        const std::uint32_t patches = Scene(file, default_patch_size(file.surfaces)).patch_count();
        CHECK(patches >= 2000);
        CHECK(patches <= 5500);
    }
}

TEST_CASE("a wanted number of patches is met closely and not exceeded")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    builder.room({0, 0, 0}, {3, 2, 1}, grey).box({1, 0, 0.2}, {1.3, 0.9, 0.7}, grey);
    const SceneFile file = builder.file();
    for (const std::uint64_t wanted : {100ull, 1000ull, 30000ull, 1000000ull}) {
        const double size = patch_size_for_count(file.surfaces, wanted);
        const double count = cell_count(file.surfaces, size);
        CHECK(count <= static_cast<double>(wanted));
        CHECK(count > 0.8 * static_cast<double>(wanted));
    }
    CHECK(Scene(file, patch_size_for_count(file.surfaces, 1)).patch_count() == 12); // the surfaces alone
}

// A strip 1e5 times as long as wide: squares of its mean area would be wider than it.
TEST_CASE("the default patch size grows where long strips give more patches than their area says")
{
    const SurfaceList strips(100, {Shape::parallelogram, {0, 0, 0}, {1e5, 0, 0}, {0, 1, 0}});
    const double size = default_patch_size(strips);
    const double by_area = std::sqrt(100 * 1e5 / 2500.0);
    CHECK(size > 1.25 * by_area);
    CHECK(size <= 3.0 * by_area);
}

// sqrt(6 x 2.1^2 / 2500) = 0.103: the next round size below is 0.1, and 6 x 21^2 patches are not too many.
TEST_CASE("the default patch size grows with the scene, also through the powers of ten")
{
    for (int exponent = -6; exponent <= 6; ++exponent) {
        const double unit = std::pow(10.0, exponent);
        SceneBuilder builder;
        const Vec3 size = 2.1 * unit * Vec3{1, 1, 1};
        const SceneFile file = builder.room({0, 0, 0}, size, builder.grey(0.5, 1.0)).file();
        CHECK(default_patch_size(file.surfaces) == doctest::Approx(0.1 * unit).epsilon(1e-12).scale(0.0));
    }
}

// A disk cut like a cake into slivers, each as long as its radius.
TEST_CASE("the default patch size leaves thousands of slivers almost whole")
{
    constexpr int n = 20000;
    SurfaceList slivers;
    for (int i = 0; i < n; ++i) {
        const auto rim = [](int k) { return Vec3{std::cos(6.283185307 * k / n), std::sin(6.283185307 * k / n), 0}; };
        slivers.push_back({Shape::triangle, {0, 0, 0}, rim(i), rim(i + 1)});
    }
    CHECK(cell_count(slivers, default_patch_size(slivers)) <= 131072.0 + 8.0 * n);
}

} // namespace tessellation_test
