#include "geometry/form_factor/exchange_area.h"

#include "base/elementary.h"
#include "geometry/random_surfaces.h"
#include "geometry/surface_pieces.h"
#include "selftest/known_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <doctest/doctest.h>
#include <vector>

namespace exchange_area_test {

using namespace multipath;

namespace {

constexpr double touching = 1e-9;

class SurfaceNumbers : public Numbers
{
public:
    using Numbers::Numbers;
    Surface surface(double spread, double size)
    {
        while (true) {
            const Shape shape = unit() < 0.5 ? Shape::triangle : Shape::parallelogram;
            const Surface s = {shape, point(-spread, spread), point(-size, size), point(-size, size)};
            if (s.area() > 0.1 * size * size)
                return s;
        }
    }
};

Surface turned_over(const Surface& s)
{
    return {s.shape, s.origin, s.edge_v, s.edge_u};
}

/// Largest relative difference, over all walls, between their area and what they exchange with all others, each wall
/// cut into n x n pieces.
double worst_row_sum(const SurfaceList& walls, int n)
{
    SurfaceList all;
    for (const Surface& wall : walls)
        for (const Surface& piece : pieces(wall, n))
            all.push_back(piece);
    double worst = 0.0;
    for (const Surface& a : all)
        worst = std::max(worst, std::abs(sum_of_exchanges({a}, all, touching) / a.area() - 1.0));
    return worst;
}

/// The six walls of a box seen from inside.
SurfaceList box(Vec3 size)
{
    const Vec3 x = {size.x, 0, 0};
    const Vec3 y = {0, size.y, 0};
    const Vec3 z = {0, 0, size.z};
    return {rectangle({}, z, x), rectangle(y, x, z),  rectangle({}, y, z),
            rectangle(x, z, y),  rectangle({}, x, y), rectangle(z, y, x)};
}

} // namespace

// Howell, A Catalog of Radiation Heat Transfer Configuration Factors, C-11 and C-14.
TEST_CASE("the walls of a cube exchange the published 0.199825 with the opposite and 0.200044 with each neighbour")
{
    const SurfaceList walls = box({1, 1, 1});
    const double across = 2.0 / pi *
                          (std::log(std::sqrt(4.0 / 3.0)) + 2.0 * std::sqrt(2.0) * std::atan(1.0 / std::sqrt(2.0)) -
                           2.0 * std::atan(1.0));
    CHECK(across == doctest::Approx(0.199825).epsilon(1e-5));
    CHECK(exchange_area(walls[0], walls[1], touching) == doctest::Approx(across).epsilon(1e-12));
    // The rest goes to four equal neighbours.
    CHECK(exchange_area(walls[0], walls[2], touching) == doctest::Approx(0.25 * (1.0 - across)).epsilon(1e-12));
}

TEST_CASE("parallel rectangles in any position agree with the closed form")
{
    SurfaceNumbers numbers(1);
    for (int k = 0; k < 200; ++k) {
        const double x = numbers.within(-6, 6);
        const double y = numbers.within(-6, 6);
        const double z = std::pow(10.0, numbers.within(-3, 1));
        const double width = std::pow(10.0, numbers.within(-2, 0)); // slivers too
        const Surface a = rectangle({}, {1, 0, 0}, {0, 1, 0});
        const Surface b = rectangle({x, y, z}, {0, 1.5, 0}, {width, 0, 0});
        const double expected = parallel_rectangles({0, 1}, {0, 1}, {x, x + width}, {y, y + 1.5}, z);
        // What the closed form loses to rounding is below 1e-14.
        CHECK(std::abs(exchange_area(a, b, touching) - expected) < 2e-4 * expected + 1e-13);
    }
}

TEST_CASE("perpendicular rectangles with and without a common edge agree with the closed form")
{
    SurfaceNumbers numbers(2);
    for (int k = 0; k < 200; ++k) {
        const double x = k % 4 == 0 ? 0.0 : numbers.within(-6, 6);
        const double y = k % 2 == 0 ? 0.0 : numbers.within(0, 5);
        const double z = k % 2 == 0 ? 0.0 : numbers.within(0, 5);
        const double width = std::pow(10.0, numbers.within(-2, 0));
        const Surface a = rectangle({0, y, 0}, {1, 0, 0}, {0, 1.5, 0});
        const Surface b = rectangle({x, 0, z}, {0, 0, 1}, {width, 0, 0});
        const double expected = perpendicular_rectangles({0, 1}, {y, y + 1.5}, {x, x + width}, {z, z + 1});
        CHECK(std::abs(exchange_area(a, b, touching) - expected) < 2e-4 * expected + 1e-13);
    }
}

// One position in the range of each rule.
TEST_CASE("neighbouring rectangles are exact to rounding, those 5 and 20 radii away to 1e-4")
{
    const Surface a = rectangle({}, {1, 0, 0}, {0, 1, 0});
    const auto error = [&](double y, double z) {
        const Surface b = rectangle({0.5, y, z}, {0, 1, 0}, {1, 0, 0});
        const double expected = parallel_rectangles({0, 1}, {0, 1}, {0.5, 1.5}, {y, y + 1}, z);
        return std::abs(exchange_area(a, b, touching) / expected - 1.0);
    };
    CHECK(error(0.3, 0.01) < 1e-12);
    CHECK(error(1.0, 0.5) < 1e-11);
    CHECK(error(2.0, 3.0) < 1e-4);
    CHECK(error(8.0, 12.0) < 1e-4);
    CHECK(error(60.0, 40.0) < 1e-4);
}

// F from a small area to a parallel rectangle above its corner (Howell B-3); the area's own size changes it by about
// its square, 1e-6.
TEST_CASE("a speck below the corner of a large rectangle agrees with the closed form for a point")
{
    const double width = 2.0, depth = 3.0, height = 0.5;
    const double u = width / height, v = depth / height;
    const double p = std::sqrt(1.0 + u * u), q = std::sqrt(1.0 + v * v);
    const double expected = (u / p * std::atan(v / p) + v / q * std::atan(u / q)) / (2.0 * pi);
    const Surface speck = rectangle({-0.5e-3, -0.5e-3, 0}, {1e-3, 0, 0}, {0, 1e-3, 0});
    const Surface large = rectangle({0, 0, height}, {0, depth, 0}, {width, 0, 0});
    CHECK(exchange_area(speck, large, touching) / speck.area() == doctest::Approx(expected).epsilon(1e-5));
}

TEST_CASE("what lies behind, or in the same plane and faces the same way, exchanges nothing")
{
    const Surface floor = rectangle({}, {1, 0, 0}, {0, 1, 0});
    CHECK(exchange_area(floor, rectangle({0, 0, -1}, {1, 0, 0}, {0, 1, 0}), touching) == 0.0);
    CHECK(exchange_area(floor, rectangle({0, 0, 1}, {1, 0, 0}, {0, 1, 0}), touching) == 0.0);
    CHECK(exchange_area(floor, rectangle({0.5, 0.5, 0}, {1, 0, 0}, {0, 1, 0}), touching) == 0.0);
    CHECK(exchange_area(floor, floor, touching) == 0.0);
    CHECK(exchange_area(floor, rectangle({0, 0, 0.5 * touching}, {0, 1, 0}, {1, 0, 0}), 0.0) > 0.0);
}

TEST_CASE("across a gap of no width face to face, the exchange is the overlap")
{
    const Surface square = rectangle({-0.5, -0.5, 0}, {1, 0, 0}, {0, 1, 0});
    const double r = std::sqrt(0.5);
    const Surface diamond = rectangle({0, -r, 0}, {-r, r, 0}, {r, r, 0});
    CHECK(exchange_area(square, diamond, touching) == doctest::Approx(2.0 * (std::sqrt(2.0) - 1.0)).epsilon(1e-12));
    const Surface inside = {Shape::triangle, {0.1, 0.1, 0}, {0, 0.2, 0}, {0.3, 0, 0}};
    CHECK(exchange_area(square, inside, touching) == doctest::Approx(0.03).epsilon(1e-12));
    CHECK(exchange_area(square, rectangle({-0.2, -0.4, 0}, {0, 1, 0}, {1, 0, 0}), touching) ==
          doctest::Approx(0.7 * 0.9).epsilon(1e-12));
    CHECK(exchange_area(square, turned_over(square), touching) == doctest::Approx(1.0).epsilon(1e-12));
    for (const double x : {-0.99, -0.6, 0.0, 0.8}) // up to a narrow strip or a corner, far from both middles
        for (const double y : {-0.9, 0.0, 0.95}) {
            const Surface shifted = rectangle({x - 0.5, y - 0.5, 0}, {0, 1, 0}, {1, 0, 0});
            const double area = (1.0 - std::abs(x)) * (1.0 - std::abs(y));
            CHECK(exchange_area(square, shifted, touching) == doctest::Approx(area).epsilon(1e-9).scale(0.0));
            CHECK(exchange_area(moved(shifted), moved(square), touching) ==
                  doctest::Approx(area).epsilon(1e-9).scale(0.0));
        }
    // Next to each other they share an edge or a corner, and no area.
    CHECK(exchange_area(square, rectangle({0.5, -0.5, 0}, {0, 1, 0}, {1, 0, 0}), touching) == 0.0);
    CHECK(exchange_area(square, rectangle({0.5, 0.5, 0}, {0, 1, 0}, {1, 0, 0}), touching) == 0.0);
    // Also when rounding leaves something over.
    CHECK(exchange_area(moved(square), moved(rectangle({0.5, -0.3, 0}, {0, 1, 0}, {1, 0, 0})), touching) == 0.0);
    // A gap that is there changes it by about its width times the perimeter.
    const Surface raised = rectangle({-0.2, -0.4, 1e-6}, {0, 1, 0}, {1, 0, 0});
    CHECK(exchange_area(square, raised, touching) == doctest::Approx(0.7 * 0.9).epsilon(1e-5));
}

TEST_CASE("a wall that goes through a floor exchanges what its upper part does")
{
    const Surface floor = rectangle({}, {1, 0, 0}, {0, 1, 0});
    const auto wall = [](double y, double low) { return rectangle({0, y, low}, {0, 0, 1 - low}, {1.3, 0, 0}); };
    for (const double y : {0.0, -0.2, -4.0, -9.0, -30.0})
        CHECK(exchange_area(floor, wall(y, -0.5), touching) ==
              doctest::Approx(exchange_area(floor, wall(y, 0.0), touching)).epsilon(1e-4));
    // In the middle of the floor only the half in front of the wall takes part.
    const Surface half = rectangle({0, 0.5, 0}, {1, 0, 0}, {0, 0.5, 0});
    CHECK(exchange_area(floor, wall(0.5, -0.5), touching) ==
          doctest::Approx(exchange_area(half, wall(0.5, 0.0), touching)).epsilon(1e-12));
}

// Random pairs, two thirds of them cut by each other's planes; some cross each other, which changes nothing here.
TEST_CASE("the exchange is the same bits both ways round, the same after a motion, and adds up over pieces")
{
    SurfaceNumbers numbers(3);
    int positive = 0;
    for (int k = 0; k < 400; ++k) {
        const double spread = k % 2 == 0 ? 1.0 : 6.0;
        const Surface a = numbers.surface(spread, 1.0);
        const Surface b = numbers.surface(spread, k % 3 == 0 ? 0.2 : 1.0);
        const double exchange = exchange_area(a, b, touching);
        CHECK(exchange == exchange_area(b, a, touching));
        const double noise = 1e-9 * b.area();
        CHECK(std::abs(exchange_area(moved(a), moved(b), touching) - exchange) < 1e-4 * exchange + noise);
        CHECK(std::abs(sum_of_exchanges(pieces(a, 2), pieces(b, 2), touching) - exchange) < 2e-4 * exchange + noise);
        positive += exchange > 0.0 ? 1 : 0;
    }
    CHECK(positive > 100);
}

// The mean of the kernel over random points, an estimate that knows nothing of planes or contours.
TEST_CASE("skew pieces in front of, behind and across each other's planes agree with brute force")
{
    SurfaceNumbers numbers(4);
    for (int k = 0; k < 40; ++k) {
        const Surface a = numbers.surface(0.5, 1.0);
        Surface b = numbers.surface(0.5, 1.0);
        b.origin = b.origin + Vec3{0, 0, 3};
        const auto point_on = [&](const Surface& s) {
            const double u = numbers.unit();
            const double v = numbers.unit();
            return s.shape == Shape::triangle && u + v > 1.0 ? s.at(1.0 - u, 1.0 - v) : s.at(u, v);
        };
        const int samples = 20000;
        double sum = 0.0;
        double squares = 0.0;
        for (int n = 0; n < samples; ++n) {
            const Vec3 d = point_on(b) - point_on(a);
            const double cosines = std::max(0.0, dot(d, a.normal())) * std::max(0.0, -dot(d, b.normal()));
            const double kernel = cosines / (pi * dot(d, d) * dot(d, d));
            sum += kernel;
            squares += kernel * kernel;
        }
        const double mean = sum / samples;
        const double deviation = std::sqrt(std::max(0.0, squares / samples - mean * mean) / samples);
        const double factor = exchange_area(a, b, touching) / (a.area() * b.area());
        // 4.5 sigma in forty comparisons; a part too small for any sample to meet counts for little.
        CHECK(std::abs(factor - mean) < 4.5 * deviation + 1e-6);
    }
}

TEST_CASE("in closed convex rooms every patch exchanges its whole area")
{
    SUBCASE("cube, whole and cut")
    {
        CHECK(worst_row_sum(box({1, 1, 1}), 1) < 1e-12);
        CHECK(worst_row_sum(box({1, 1, 1}), 6) < 1e-5);
    }
    SUBCASE("flat box, turned")
    {
        SurfaceList walls = box({5, 0.5, 3});
        std::transform(walls.begin(), walls.end(), walls.begin(), moved);
        CHECK(worst_row_sum(walls, 5) < 1e-5);
    }
    SUBCASE("tetrahedron of triangles, its edges at many angles")
    {
        const Vec3 p = {0, 0, 0}, q = {1.2, 0.1, 0}, r = {0.3, 1, -0.1}, s = {0.2, 0.4, 0.9};
        const auto face = [](Vec3 a, Vec3 b, Vec3 c) { return Surface{Shape::triangle, a, b - a, c - a}; };
        const SurfaceList walls = {face(p, q, r), face(p, s, q), face(q, s, r), face(r, s, p)};
        CHECK(worst_row_sum(walls, 1) < 1e-8);
        CHECK(worst_row_sum(walls, 5) < 1e-5);
    }
}

// From three of its radii on, a small piece is asked at a few points, by Lambert's formula, from half of that on at
// those of its quarters; of a piece that goes through the wall the part in front.
TEST_CASE("a small piece near a large one, or behind a part of it, gets what the contour integral says")
{
    const Surface wall = rectangle({0, -1, -1}, {0, 2, 0}, {0, 0, 2}); // faces x > 0
    const FlatPolygon wall_polygon = polygon_of(wall);
    int cut = 0;
    for (const Shape shape : {Shape::parallelogram, Shape::triangle})
        for (const double size : {0.1, 0.02})
            for (const double radii : {0.3, 0.7, 1.4, 1.6, 2.9, 3.1, 4.0, 6.0, 20.0})
                for (const double turn : {0.0, 0.7, 1.5, 2.2}) // from 1.57 on the horizon cuts the wall
                    for (const double height : {0.9, 1.0, 1.1}) {
                        CAPTURE(size);
                        CAPTURE(radii);
                        CAPTURE(turn);
                        CAPTURE(height);
                        const double x = radii * size * std::sqrt(0.5);
                        const Vec3 across = {std::sin(turn), std::cos(turn), 0.0};
                        Surface speck =
                            rectangle(Vec3{x, height, 0.0} - 0.5 * size * across, {0, 0, size}, size * across);
                        speck.shape = shape;
                        const FlatPolygon speck_polygon = polygon_of(speck);
                        const FlatPolygon front = part_in_front(speck_polygon, {}, wall.normal(), 1e-9);
                        const FlatPolygon seen = part_in_front(wall_polygon, speck.centre(), speck.normal(), 1e-9);
                        const bool none = front.empty() || seen.empty();
                        const double expected = none ? 0.0 : contour_integral(front, seen);
                        cut += heights(speck_polygon, {}, wall.normal()).low < 0.0 && expected > 0.0 ? 1 : 0;
                        CHECK(exchange_area(wall, speck, 1e-9) == doctest::Approx(expected).epsilon(2e-5));
                        CHECK(exchange_area(speck, wall, 1e-9) == exchange_area(wall, speck, 1e-9));
                    }
    CHECK(cut >= 20);
}

} // namespace exchange_area_test
