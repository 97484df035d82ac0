#include "scene/tessellation.h"

#include "scene/input_error.h"

#include <doctest/doctest.h>

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
    const std::vector<Surface> surfaces = {{Shape::parallelogram, {0, 0, 0}, {1, 0, 0}, {0, 2, 0}},
                                           {Shape::triangle, {0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}}};
    const double size = 0.1;
    CHECK(cell_count(surfaces, size) ==
          static_cast<double>(tessellate(surfaces[0], size).cell_count() + tessellate(surfaces[1], size).cell_count()));
    CHECK(cell_count(surfaces, 1e-12) == doctest::Approx(2e24 + 1.25e24)); // the triangle by its longest edge, squared
    CHECK(cell_count(surfaces, 1e-300) > 1e300);
}

// The centre of every cell is in that cell, and the cells tile the surface without turning over.
TEST_CASE("cell numbers and cells belong together, and the cells' areas add up")
{
    const Surface parallelogram = {Shape::parallelogram, {1, 2, 3}, {1, 0.5, 0}, {0.2, 0, 2}};
    const Surface triangle = {Shape::triangle, {1, 2, 3}, {1, 0.5, 0}, {0.2, 0, 2}};
    for (const Surface& surface : {parallelogram, triangle})
        for (const double size : {3.0, 0.5, 0.11, 0.03}) {
            const Tessellation tessellation = tessellate(surface, size);
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
    for (const Shape shape : {Shape::parallelogram, Shape::triangle}) {
        const Surface surface = {shape, {1, 2, 3}, {1, 0.5, 0}, {0.2, 0, 2}};
        const Tessellation tessellation = tessellate(surface, 0.3);
        for (std::uint32_t cell = 0; cell < tessellation.cell_count(); ++cell) {
            const Surface piece = tessellation.cell(surface, cell);
            std::vector<Vec3> around = {piece.origin, piece.at(1, 0), piece.at(1, 1), piece.at(0, 1)};
            if (shape == Shape::triangle)
                around.erase(around.begin() + 2);
            const CellCorners corners = tessellation.corners(cell);
            REQUIRE(corners.count == around.size());
            for (std::size_t k = 0; k < corners.count; ++k) {
                const double u = static_cast<double>(corners.points[k].i) / tessellation.cells_u;
                const double v = static_cast<double>(corners.points[k].j) / tessellation.cells_v;
                REQUIRE(length(surface.at(u, v) - around[k]) < 1e-14); // rounding
            }
        }
    }
}

TEST_CASE("points on or just beyond the border fall into cells at the border")
{
    const Tessellation grid{Shape::parallelogram, 3, 4};
    CHECK(grid.cell_at(-1e-17, 0.0) == 0);
    CHECK(grid.cell_at(1.0, 1.0 + 1e-16) == 11);
    const Tessellation triangles{Shape::triangle, 3, 3};
    for (const double u : {0.0, 1.0 / 3, 0.5, 2.0 / 3, 0.9, 1.0})
        for (const double beyond : {0.0, 1e-16, 1e-15})
            CHECK(triangles.cell_at(u, 1.0 - u + beyond) < 9);
    CHECK(triangles.cell_at(1.0, 0.0) == 8);
    CHECK(triangles.cell_at(0.0, 1.0) == 4);
}

} // namespace tessellation_test
