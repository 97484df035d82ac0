#include "geometry/form_factor/contour_integral.h"

#include "geometry/surface_pieces.h"
#include "selftest/rectangle_exchange.h"

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
    // Edges that are parallel but for the rounding of a rotation, or for a little more. The true change is 0.12 tilt;
    // where edges begin to count as skew, at 1e-6, both ways are about 2e-6 off.
    const Surface a = rectangle({}, {1, 0, 0}, {0, 1, 0});
    const double straight = exchange(a, rectangle({0.3, 0.2, 0.7}, {0, 1, 0}, {1, 0, 0}));
    for (const double tilt : {1e-15, 1e-10, 1e-7, 1e-6, 1e-5, 1e-4}) {
        CAPTURE(tilt);
        const Surface b = rectangle({0.3, 0.2, 0.7}, {-tilt, 1, 0}, {1, tilt, 0});
        CHECK(std::abs(exchange(a, b) / straight - 1.0) < tilt + 3e-6);
    }
}

} // namespace contour_integral_test
