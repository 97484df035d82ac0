#include "sampling/warp.h"

#include "sampling/trigonometry.h"

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
            const Barycentric p = square_to_uniform_triangle(a, b);
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

} // namespace warp_test
