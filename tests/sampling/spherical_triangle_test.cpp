#include "sampling/spherical_triangle.h"

#include "sampling/random.h"

#include <cmath>
#include <doctest/doctest.h>

namespace spherical_triangle_test {

using namespace multipath;

namespace {

constexpr double pi = 3.14159265358979323846;

} // namespace

TEST_CASE("solid angles: an octant, a small triangle, a degenerate one")
{
    CHECK(SphericalTriangle({1, 0, 0}, {0, 1, 0}, {0, 0, 1}).solid_angle() == doctest::Approx(0.5 * pi).epsilon(1e-14));
    const double h = 1e-4; // seen from distance 1 its plane area is its solid angle up to h^2
    const SphericalTriangle small(normalized(Vec3{0, 0, 1}), normalized(Vec3{h, 0, 1}), normalized(Vec3{0, h, 1}));
    CHECK(small.solid_angle() == doctest::Approx(0.5 * h * h).epsilon(1e-7));
    CHECK(SphericalTriangle({1, 0, 0}, {0, 1, 0}, normalized(Vec3{1, 1, 0})).solid_angle() == 0.0);
}

// Equal solid angles get equal numbers of directions: here the parts of a triangle cut by a plane through one corner.
TEST_CASE("directions are uniform in the triangle and never leave it")
{
    const Vec3 a = normalized(Vec3{1, 0.1, 0.2});
    const Vec3 b = normalized(Vec3{0.2, 1, -0.1});
    const Vec3 c = normalized(Vec3{-0.3, 0.4, 1});
    const Vec3 middle = normalized(b + c);
    const SphericalTriangle whole(a, b, c);
    const double share = SphericalTriangle(a, b, middle).solid_angle() / whole.solid_angle();
    const Vec3 divider = cross(a, middle);
    int on_the_side_of_b = 0;
    constexpr int count = 100000;
    for (std::uint64_t k = 0; k < count; ++k) {
        const Vec3 d = whole.direction(bits_to_unit(random_bits(1, 2 * k)), bits_to_unit(random_bits(1, 2 * k + 1)));
        CHECK(length(d) == doctest::Approx(1.0).epsilon(1e-12));
        CHECK(dot(d, cross(a, b)) > -1e-9);
        CHECK(dot(d, cross(b, c)) > -1e-9);
        CHECK(dot(d, cross(c, a)) > -1e-9);
        on_the_side_of_b += (dot(divider, d) > 0.0) == (dot(divider, b) > 0.0) ? 1 : 0;
    }
    const double deviation = std::sqrt(count * share * (1.0 - share));
    CHECK(std::abs(on_the_side_of_b - count * share) < 4.0 * deviation);
}

} // namespace spherical_triangle_test
