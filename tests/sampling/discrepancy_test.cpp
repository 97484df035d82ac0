#include "sampling/discrepancy.h"

#include "statistics.h"

#include <cmath>
#include <doctest/doctest.h>

namespace discrepancy_test {

using namespace multipath;

namespace {

PointSet sample(const char* name, int dimensions, std::uint64_t count, std::uint64_t seed = 1)
{
    return points_of(*make_sequence(name, seed, dimensions), 0, count);
}

/// The mean square of the local discrepancy by the midpoint rule over `cells` x `cells` boxes.
double l2_by_integration(const PointSet& points, int cells)
{
    double sum = 0.0;
    for (int i = 0; i < cells; ++i)
        for (int j = 0; j < cells; ++j) {
            const double x = (i + 0.5) / cells;
            const double y = (j + 0.5) / cells;
            double inside = 0.0;
            for (std::size_t n = 0; n < points.size(); ++n)
                inside += points.at(n, 0) < x && points.at(n, 1) < y ? 1.0 : 0.0;
            const double local = inside / static_cast<double>(points.size()) - x * y;
            sum += local * local;
        }
    return std::sqrt(sum / cells / cells);
}

} // namespace

// In one dimension the local discrepancy of the point 1/2 is -q before it and 1 - q behind it; its square integrates to
// 2 * 1/24. In d dimensions, with P = prod q: the integral of P^2 is 3^-d, of 2 P over q > 1/2 it is 2 (3/8)^d, of 1
// 2^-d.
TEST_CASE("one point in the middle has the L2 star discrepancy of the closed form")
{
    CHECK(l2_star_discrepancy({1, {0.5}}) == doctest::Approx(std::sqrt(1.0 / 12.0)).epsilon(1e-14));
    for (int d = 1; d <= 6; ++d) {
        const double square = std::pow(3.0, -d) - 2.0 * std::pow(0.375, d) + std::pow(0.5, d);
        const PointSet middle{d, std::vector<double>(static_cast<std::size_t>(d), 0.5)};
        CHECK(l2_star_discrepancy(middle) == doctest::Approx(std::sqrt(square)).epsilon(1e-13));
    }
}

// Midpoints of N cells: the local discrepancy is a saw tooth of height 1/(2N), whose mean square is 1/(12 N^2).
TEST_CASE("midpoints of equal cells have the L2 star discrepancy 1/(sqrt(12) N), the least in one dimension")
{
    for (const int count : {1, 2, 7, 64}) {
        PointSet midpoints{1, {}};
        for (int i = 0; i < count; ++i)
            midpoints.coordinates.push_back((i + 0.5) / count);
        CHECK(l2_star_discrepancy(midpoints) == doctest::Approx(1.0 / std::sqrt(12.0) / count).epsilon(1e-9));
    }
}

// The midpoint rule errs by up to one cell's width around every step of the count: about 1/400 relative here.
TEST_CASE("in the plane the L2 star discrepancy is that of the definition")
{
    for (const char* name : {"random", "halton"}) {
        const PointSet points = sample(name, 2, 9);
        CHECK(l2_star_discrepancy(points) == doctest::Approx(l2_by_integration(points, 400)).epsilon(0.01));
    }
}

// Independent seeds: the mean of the squares has a standard error that the samples give; 4 of them (once in 16,000).
TEST_CASE("random points have the expected mean square")
{
    for (const int dimensions : {2, 4}) {
        std::vector<double> squares;
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            const double discrepancy = l2_star_discrepancy(sample("random", dimensions, 32, seed));
            squares.push_back(discrepancy * discrepancy);
        }
        const double expected = random_l2_star_discrepancy(32, dimensions);
        CHECK(estimate(squares).agrees_with(expected * expected));
    }
}

// From 2^6 to 2^10 points N^-1 log N falls by a factor of 10 in the plane, N^-1/2 by 4.
TEST_CASE("the discrepancy of Sobol's points falls faster than that of random points")
{
    CHECK(l2_star_discrepancy(sample("sobol", 2, 64)) > 7.0 * l2_star_discrepancy(sample("sobol", 2, 1024)));
    CHECK(random_l2_star_discrepancy(64, 2) ==
          doctest::Approx(4.0 * random_l2_star_discrepancy(1024, 2)).epsilon(1e-12));
}

} // namespace discrepancy_test
