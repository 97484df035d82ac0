#include "geometry/bounds.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <doctest/doctest.h>

namespace bounds_test {

using namespace multipath;

namespace {

/// Read again after it was written with so many significant digits.
double written(double x, int digits)
{
    char text[64];
    std::snprintf(text, sizeof text, "%.*g", digits, x);
    return std::strtod(text, nullptr);
}

} // namespace

TEST_CASE("coordinates written with the digits of their box are exact to a millionth of its diagonal, wherever it is")
{
    const Vec3 size = {0.5, 2.0, 1.3};
    for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z})
        for (const double away : {-1e9, -123456.7, -321.0, -2.1, -0.7, 0.0, 3.3, 432.1, 7654321.0}) {
            CAPTURE(away);
            Vec3 low = {-0.123456789, 0.3141592653, 0.0271828182};
            low.*axis += away;
            Bounds box;
            box.include(low);
            box.include(low + size);
            const int digits = coordinate_digits(box, 7);
            for (int k = 0; k <= 10; ++k)
                for (double Vec3::*c : {&Vec3::x, &Vec3::y, &Vec3::z}) {
                    const double x = (low + 0.1 * k * size).*c;
                    CHECK(std::abs(written(x, digits) - x) <= 1e-6 * box.diagonal());
                }
        }
}

} // namespace bounds_test
