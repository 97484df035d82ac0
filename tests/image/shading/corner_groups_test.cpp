#include "image/shading/corner_groups.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace corner_groups_test {

using namespace multipath;

namespace {

Rgb ramp(double u, double v)
{
    return {1.0 + 2.0 * u + 3.0 * v, 5.0 - 4.0 * u, 2.0};
}

double difference(Rgb a, Rgb b)
{
    return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
}

} // namespace

// Each of the n^2 triangles and each of the m n parallelograms has 3 or 4 corners, each of which belongs to one corner
// of the lattice.
TEST_CASE("the cells around all corners are the corners of all cells")
{
    for (const Tessellation& tessellation :
         {Tessellation{Shape::parallelogram, 3, 5, nullptr}, Tessellation{Shape::parallelogram, 1, 1, nullptr},
          Tessellation{Shape::triangle, 4, 4, nullptr}, Tessellation{Shape::triangle, 1, 1, nullptr}}) {
        const CornerLattice lattice(tessellation);
        std::set<std::pair<std::uint32_t, std::uint32_t>> corners;
        std::size_t count = 0;
        for (const GridPoint point : lattice.points())
            for (const std::optional<CellCorner>& cell : lattice.around(point))
                if (cell) {
                    corners.insert({cell->cell, cell->number});
                    ++count;
                }
        CHECK(count == tessellation.cell_count() * (tessellation.shape == Shape::triangle ? 3 : 4));
        CHECK(corners.size() == count);
    }
}

// Against the geometry of the cells: the numbered corner of the cell lies where the lattice says, and two successive
// cells share an edge, so that their centres are closer than those of any cells that touch in a corner only.
TEST_CASE("the cells around a corner have it, and follow each other from edge to edge")
{
    for (const Tessellation& tessellation :
         {Tessellation{Shape::parallelogram, 3, 5, nullptr}, Tessellation{Shape::triangle, 4, 4, nullptr}}) {
        const Surface surface = {tessellation.shape, {}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
        const bool triangle = tessellation.shape == Shape::triangle;
        const CornerLattice lattice(tessellation);
        for (const GridPoint point : lattice.points()) {
            const auto cells = lattice.around(point);
            for (std::size_t k = 0; k < cells.size(); ++k) {
                if (!cells[k])
                    continue;
                const Surface cell = tessellation.cell(surface, cells[k]->cell);
                const Vec3 corners[] = {cell.origin, cell.origin + cell.edge_u,
                                        triangle ? cell.origin + cell.edge_v : cell.at(1.0, 1.0),
                                        cell.origin + cell.edge_v};
                const Vec3 place = surface.at(lattice.u(point), lattice.v(point));
                CHECK(length(corners[cells[k]->number] - place) < 1e-14); // rounding
                const auto& next = cells[(k + 1) % cells.size()];
                if (!next)
                    continue;
                const Vec3 way = tessellation.cell(surface, next->cell).centre() - cell.centre();
                const bool along_u = k % 2 == 0;
                if (!triangle) {
                    CHECK(std::abs(along_u ? way.y : way.x) < 1e-14); // rounding
                    CHECK(std::abs(along_u ? way.x : way.y) == doctest::Approx(along_u ? 1.0 / 3.0 : 1.0 / 5.0));
                } else {
                    CHECK(length(way) < 0.8 / 4.0); // at most sqrt(5) / 3 of an edge; else a whole one
                }
            }
        }
    }
}

TEST_CASE("given a ramp at its corners, every cell shows the ramp")
{
    for (const Tessellation& tessellation :
         {Tessellation{Shape::parallelogram, 3, 5, nullptr}, Tessellation{Shape::triangle, 3, 3, nullptr}}) {
        const CornerLattice lattice(tessellation);
        std::vector<Rgb> corners(CornerLattice::per_cell * tessellation.cell_count());
        for (const GridPoint point : lattice.points())
            for (const std::optional<CellCorner>& cell : lattice.around(point))
                if (cell)
                    corners[CornerLattice::per_cell * cell->cell + cell->number] =
                        ramp(lattice.u(point), lattice.v(point));
        const bool triangle = tessellation.shape == Shape::triangle;
        for (double u = 0.0; u <= 1.0; u += 0.07)
            for (double v = 0.0; (triangle ? u + v : v) <= 1.0; v += 0.07)
                CHECK(difference(lattice.interpolated(corners.data(), u, v), ramp(u, v)) < 1e-13); // rounding
    }
}

} // namespace corner_groups_test
