#include "image/corner_lattice.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

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

TEST_CASE("corners are numbered without gaps")
{
    for (const Tessellation& tessellation :
         {Tessellation{Shape::parallelogram, 3, 5}, Tessellation{Shape::triangle, 4, 4}}) {
        const CornerLattice lattice(tessellation);
        std::set<std::size_t> numbers;
        for (std::uint32_t j = 0; j <= lattice.last_row(); ++j)
            for (std::uint32_t i = 0; i <= lattice.last_column(j); ++i)
                numbers.insert(lattice.number(i, j));
        CHECK(numbers.size() == lattice.corner_count());
        CHECK(*numbers.rbegin() == lattice.corner_count() - 1);
    }
    CHECK(CornerLattice({Shape::parallelogram, 3, 5}).corner_count() == 24);
    CHECK(CornerLattice({Shape::triangle, 4, 4}).corner_count() == 15);
}

// Each of the n^2 triangles and each of the m n parallelograms has 3 or 4 corners.
TEST_CASE("the patches around all corners add up to the corners of all patches")
{
    const auto sum = [](const CornerLattice& lattice) {
        std::uint32_t cells = 0;
        for (std::uint32_t j = 0; j <= lattice.last_row(); ++j)
            for (std::uint32_t i = 0; i <= lattice.last_column(j); ++i)
                cells += lattice.cells_at(i, j);
        return cells;
    };
    CHECK(sum(CornerLattice({Shape::parallelogram, 3, 5})) == 4 * 15);
    CHECK(sum(CornerLattice({Shape::parallelogram, 1, 1})) == 4);
    CHECK(sum(CornerLattice({Shape::triangle, 4, 4})) == 3 * 16);
    CHECK(sum(CornerLattice({Shape::triangle, 1, 1})) == 3);
}

TEST_CASE("a linear ramp over a parallelogram is reproduced everywhere, its border included")
{
    for (const Tessellation& tessellation :
         {Tessellation{Shape::parallelogram, 2, 2}, Tessellation{Shape::parallelogram, 7, 3}}) {
        const CornerLattice lattice(tessellation);
        const std::vector<Rgb> corners = lattice.corner_values(ramp);
        for (const double u : {0.0, 0.03, 0.5, 0.77, 1.0})
            for (const double v : {0.0, 0.2, 0.51, 1.0})
                CHECK(difference(lattice.interpolated(corners.data(), u, v), ramp(u, v)) < 1e-13); // rounding
    }
}

TEST_CASE("given a ramp at its corners, a triangle shows the ramp in every patch")
{
    const CornerLattice lattice({Shape::triangle, 3, 3});
    std::vector<Rgb> corners(lattice.corner_count());
    for (std::uint32_t j = 0; j <= lattice.last_row(); ++j)
        for (std::uint32_t i = 0; i <= lattice.last_column(j); ++i)
            corners[lattice.number(i, j)] = ramp(lattice.u(i), lattice.v(j));
    for (double u = 0.0; u <= 1.0; u += 0.07)
        for (double v = 0.0; u + v <= 1.0; v += 0.07)
            CHECK(difference(lattice.interpolated(corners.data(), u, v), ramp(u, v)) < 1e-13); // rounding
}

TEST_CASE("a triangle's inner corner is the mean of the six patches around it")
{
    const CornerLattice lattice({Shape::triangle, 3, 3});
    const std::vector<Rgb> corners = lattice.corner_values(ramp);
    CHECK(difference(corners[lattice.number(1, 1)], ramp(1.0 / 3.0, 1.0 / 3.0)) < 1e-13); // symmetric, so exact
}

TEST_CASE("a constant stays constant")
{
    const auto constant = [](double, double) { return Rgb{0.3, 0.7, 1.9}; };
    for (const Tessellation& tessellation :
         {Tessellation{Shape::parallelogram, 1, 4}, Tessellation{Shape::triangle, 5, 5}})
        for (const Rgb& corner : CornerLattice(tessellation).corner_values(constant))
            CHECK(difference(corner, {0.3, 0.7, 1.9}) < 1e-14); // rounding
}

// Bright against dark in the middle: straight extrapolation would leave the range of the values.
TEST_CASE("a step does not overshoot and nothing becomes negative")
{
    const CornerLattice lattice({Shape::parallelogram, 4, 1});
    const std::vector<Rgb> corners = lattice.corner_values([](double u, double) {
        const double value = u < 0.25 || u > 0.75 ? 0.0 : 1.0;
        return Rgb{value, 1.0 - value, u < 0.25 ? 0.1 : 5.0};
    });
    for (const Rgb& corner : corners) {
        CHECK(corner.r >= 0.0);
        CHECK(corner.r <= 1.0);
        CHECK(corner.g >= 0.0);
        CHECK(corner.g <= 1.0);
        CHECK(corner.b >= 0.0);
    }
}

// By hand: from the border inward 5, 1, 0.9 the slopes are 4 and 0.1, so the corner is 5 + 0.1 / 2; for 2, 1, 2 they
// disagree in sign, so the border patch goes on level.
TEST_CASE("the border continues the smaller slope, and none where slopes disagree")
{
    const CornerLattice lattice({Shape::parallelogram, 3, 1});
    const std::vector<Rgb> corners = lattice.corner_values([](double u, double) {
        return u < 1.0 / 3.0 ? Rgb{5.0, 2.0, 0.0} : u < 2.0 / 3.0 ? Rgb{1.0, 1.0, 0.0} : Rgb{0.9, 2.0, 0.0};
    });
    CHECK(corners[lattice.number(0, 0)].r == doctest::Approx(5.05));
    CHECK(corners[lattice.number(0, 0)].g == doctest::Approx(2.0));
}
