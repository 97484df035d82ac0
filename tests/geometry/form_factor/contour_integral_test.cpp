#include "geometry/form_factor/exchange_area.h"

#include "geometry/surface_pieces.h"
#include "selftest/known_scenes.h"

#include <cmath>
#include <doctest/doctest.h>

namespace contour_integral_test {

using namespace multipath;

namespace {

double exchange(const Surface& a, const Surface& b)
{
    return contour_integral(polygon_of(a), polygon_of(b));
}

} // namespace

TEST_CASE("rectangles near each other agree with the closed forms almost to rounding")
{
    const Surface a = rectangle({}, {1, 0, 0}, {0, 1, 0});
    for (const double gap : {1e-6, 1e-3, 0.1, 1.0, 2.0}) {
        CAPTURE(gap);
        const double above = exchange(a, rectangle({0.5, 0.2, gap}, {0, 1, 0}, {1.3, 0, 0}));
        CHECK(above ==
              doctest::Approx(parallel_rectangles({0, 1}, {0, 1}, {0.5, 1.8}, {0.2, 1.2}, gap)).epsilon(1e-11));
        const double beside =
            exchange(rectangle({0, gap, 0}, {1, 0, 0}, {0, 1, 0}), rectangle({0.5, 0, 0}, {0, 0, 0.7}, {1.3, 0, 0}));
        CHECK(beside ==
              doctest::Approx(perpendicular_rectangles({0, 1}, {gap, 1 + gap}, {0.5, 1.8}, {0, 0.7})).epsilon(1e-11));
    }
}

// Where edges pass close by each other at an angle, the integral along them varies over lengths from the gap to the
// edge.
TEST_CASE("a triangle that stands askew almost on a floor adds up over its pieces")
{
    const Surface floor = rectangle({-1, -1, 0}, {2, 0, 0}, {0.3, 2, 0});
    for (const double gap : {1e-1, 1e-2, 1e-3, 1e-5, 0.0}) {
        CAPTURE(gap);
        const Surface askew = {Shape::triangle, {-0.6, -0.97, gap}, {0.2, 0.9, 0.5}, {1.5, 0.1, 0.02}};
        const double whole = exchange_area(floor, askew, 1e-9); // the plane of the triangle cuts the floor
        CHECK(whole > 0.1 * askew.area());
        CHECK(sum_of_exchanges(pieces(floor, 3), pieces(askew, 2), 1e-9) == doctest::Approx(whole).epsilon(1e-6));
    }
}

// The wedge of two long plates: F = 1 - sin(angle / 2) in two dimensions.
TEST_CASE("plates that are almost in one plane or almost parallel keep their digits")
{
    for (const double angle : {1e-5, 1e-3, 0.1, 3.0}) {
        CAPTURE(angle);
        const double length = 1e4;
        const Surface a = rectangle({0, 0, 0}, {1, 0, 0}, {0, length, 0});
        const Surface b = rectangle({0, 0, 0}, {0, length, 0}, {std::cos(angle), 0, std::sin(angle)});
        const double expected = 1.0 - std::sin(0.5 * angle);
        // The ends of the plates lose about width / length.
        CHECK(exchange(a, b) / length == doctest::Approx(expected).epsilon(1e-3));
    }
    // Edges that are parallel but for the rounding of a rotation, or for a little more. The true change is 0.12 tilt.
    const Surface a = rectangle({}, {1, 0, 0}, {0, 1, 0});
    const double straight = exchange(a, rectangle({0.3, 0.2, 0.7}, {0, 1, 0}, {1, 0, 0}));
    for (const double tilt : {1e-15, 1e-10, 1e-9, 1.1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4}) {
        CAPTURE(tilt);
        const Surface b = rectangle({0.3, 0.2, 0.7}, {-tilt, 1, 0}, {1, tilt, 0});
        CHECK(std::abs(exchange(a, b) / straight - 1.0) < 0.13 * tilt + 2e-9);
    }
}

// Coordinates are often rounded to six digits: edges of one direction then differ by some 1e-6, and of slivers far from
// each other every digit is needed. The oracle is Lambert's formula at the middles of small pieces.
TEST_CASE("slivers far from each other keep their digits, however nearly parallel their edges are")
{
    const Surface a = rectangle({15.4489, 1.27469, 3.52563}, {0, -0.94469, 0.12437}, {-0.05, 0, 0});
    for (const double tilt : {0.0, 1e-10, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 0.009, 0.011, 0.1}) {
        CAPTURE(tilt);
        const Vec3 along = {tilt, 0.94469, -0.12437};
        const Surface b = {Shape::triangle, {15.7489, 1.37677, 0.180392}, 1.4504 * along, {0, -0.02375, -0.180392}};
        double views = 0.0;
        for (const Surface& piece : pieces(a, 6))
            views += piece.area() * irradiance_from(polygon_of(b), piece.centre(), a.normal());
        CHECK(exchange(a, b) == doctest::Approx(views).epsilon(1e-4));
    }
}

TEST_CASE("edges that nearly coincide, cross or continue each other keep their digits")
{
    const Surface floor = rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    for (const double shift : {0.0, 0.3, 1.0})
        for (const double tilt : {1e-8, 1e-6, 1e-5, 1e-3, 5e-3}) {
            CAPTURE(shift);
            CAPTURE(tilt);
            // A wall along the edge of the floor or of what continues it, turned about its end.
            const Surface wall = rectangle({-tilt, shift - 0.5, 0}, {0, 0, 1}, {tilt, -1, 0});
            const double whole = exchange(floor, wall);
            const double straight = exchange(floor, rectangle({0, shift - 0.5, 0}, {0, 0, 1}, {0, -1, 0}));
            CHECK(whole == doctest::Approx(straight).epsilon(3.0 * tilt));
            CHECK(sum_of_exchanges(pieces(floor, 3), pieces(wall, 2), 1e-9) == doctest::Approx(whole).epsilon(1e-6));
        }
}

} // namespace contour_integral_test
