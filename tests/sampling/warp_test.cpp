#include "base/elementary.h"
#include "sampling/random.h"
#include "sampling/warp.h"

#include <cmath>
#include <doctest/doctest.h>

namespace warp_test {

using namespace multipath;

TEST_CASE("sine and cosine agree with the C library to 2e-16")
{
    const long double two_pi = 6.283185307179586476925286766559L;
    for (int k = 0; k <= 100000; ++k) {
        const double turns = k / 100000.0;
        const SinCos ours = sin_cos_of_turns(turns);
        CHECK(std::abs(ours.sin - static_cast<double>(std::sin(two_pi * turns))) < 2.3e-16);
        CHECK(std::abs(ours.cos - static_cast<double>(std::cos(two_pi * turns))) < 2.3e-16);
    }
}

// The moments of a target follow from its density. A midpoint grid of n^2 points integrates smooth maps to O(1/n^2),
// the square roots of these maps to O(n^-1.5) or better.
TEST_CASE("the maps have the moments of their targets")
{
    constexpr int n = 400;
    Vec3 sphere_mean;
    Vec3 sphere_squares;
    double cosine_mean = 0.0;
    double u_mean = 0.0;
    double v_mean = 0.0;
    double uv_mean = 0.0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double a = (i + 0.5) / n;
            const double b = (j + 0.5) / n;
            const Vec3 s = square_to_uniform_sphere(a, b);
            CHECK(std::abs(length(s) - 1.0) < 1e-15);
            sphere_mean = sphere_mean + s;
            sphere_squares = sphere_squares + Vec3{s.x * s.x, s.y * s.y, s.z * s.z};
            const Vec3 h = square_to_cosine_hemisphere(a, b);
            CHECK((h.z >= 0.0 && std::abs(length(h) - 1.0) < 1e-15));
            cosine_mean += h.z;
            const SurfacePoint p = square_to_uniform_triangle(a, b);
            CHECK((p.u >= 0 && p.v >= 0 && p.u + p.v <= 1.0 + 1e-15));
            u_mean += p.u;
            v_mean += p.v;
            uv_mean += p.u * p.v;
        }
    const double count = n * n;
    CHECK(length(sphere_mean) / count < 1e-12);
    CHECK(sphere_squares.x / count == doctest::Approx(1.0 / 3).epsilon(1e-5));
    CHECK(sphere_squares.y / count == doctest::Approx(1.0 / 3).epsilon(1e-5));
    CHECK(sphere_squares.z / count == doctest::Approx(1.0 / 3).epsilon(1e-5));
    CHECK(cosine_mean / count == doctest::Approx(2.0 / 3).epsilon(1e-4)); // integral of cos^2 / pi over the hemisphere
    CHECK(u_mean / count == doctest::Approx(1.0 / 3).epsilon(1e-4));
    CHECK(v_mean / count == doctest::Approx(1.0 / 3).epsilon(1e-4));
    CHECK(uv_mean / count == doctest::Approx(1.0 / 12).epsilon(1e-4)); // 2 * integral of u v over the triangle
}

namespace {

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

} // namespace warp_test
