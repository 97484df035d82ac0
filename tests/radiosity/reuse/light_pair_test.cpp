#include "radiosity/reuse/light_pair.h"

#include "form_factor.h"

#include <doctest/doctest.h>

namespace light_pair_test {

using namespace multipath;

namespace {

Surface rectangle(Vec3 corner, Vec3 edge_u, Vec3 edge_v)
{
    return {Shape::parallelogram, corner, edge_u, edge_v};
}

} // namespace

// The four squares around a square opposite another get equal shares of what the other does not get.
TEST_CASE("the exchange of squares that share an edge is exact")
{
    const Surface floor = rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0});
    const Surface wall = rectangle({0, 0, 0}, {0, 1, 0}, {0, 0, 1});
    const double expected = 0.25 * (1.0 - opposite_form_factor());
    CHECK(LightPair(floor, wall, 1e-9).exchange() == doctest::Approx(expected).epsilon(1e-6)); // the contour's error
    CHECK(LightPair(wall, floor, 1e-9).exchange() == doctest::Approx(expected).epsilon(1e-6));
}

// A strip gets the part of the square's exchange that a strip of the square's area has: strips add up to it.
TEST_CASE("the exchange with needles along a light is that of what they make up")
{
    const Surface wall = rectangle({0, 0, 0}, {0, 1, 0}, {0, 0, 1});
    double sum = 0.0;
    constexpr int count = 500;
    for (int k = 0; k < count; ++k)
        sum += LightPair(rectangle({0, 0, k / 500.0}, {0, 0, 1 / 500.0}, {1, 0, 0}), wall, 1e-9).exchange();
    CHECK(sum == doctest::Approx(0.25 * (1.0 - opposite_form_factor())).epsilon(1e-5)); // of hundreds that cancel
}

TEST_CASE("a light that cuts through a patch gives no more than either can")
{
    const Surface patch = rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0});
    const Surface light = rectangle({0.5, -1, 0}, {0, 2, 0}, {0, 0, 1}); // faces x < 0.5, seen above the patch only
    const Surface upper = rectangle({0.5, 0, 0}, {0, 1, 0}, {0, 0, 1});
    const double cut = LightPair(patch, light, 1e-9).exchange();
    CHECK(cut == doctest::Approx(LightPair(patch, upper, 1e-9).exchange()).epsilon(1e-6));
    CHECK(cut > 0.0);
    CHECK(cut < 0.5);
}

} // namespace light_pair_test
