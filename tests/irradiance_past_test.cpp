#include "irradiance_past.h"

#include "base/elementary.h"
#include "geometry/intersector/intersector.h"
#include "sampling/random.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <vector>

namespace occluded_lamp_test {

using namespace multipath;

namespace {

constexpr Vec3 up = {0, 1, 0};

Surface quad(Vec3 origin, Vec3 u, Vec3 v)
{
    return {Shape::parallelogram, origin, u, v};
}

const Surface lamp = quad({-0.5, 2.0, -0.4}, {1, 0, 0}, {0, 0, 0.8}); // looks down

struct Estimate
{
    double mean;
    double standard_error;
};

/// By shadow rays to uniform points of the lamp.
Estimate sampled(const std::vector<Surface>& blockers, Vec3 point, std::uint64_t key)
{
    constexpr int rays = 40000;
    const Intersector occluders(SurfaceList(blockers.begin(), blockers.end()));
    double sum = 0.0;
    double square = 0.0;
    for (std::uint64_t n = 0; n < rays; ++n) {
        const double a = bits_to_unit(random_bits(key, 2 * n));
        const double b = bits_to_unit(random_bits(key, 2 * n + 1));
        const Vec3 d = lamp.at(a, b) - point;
        const double distance = dot(d, d);
        const double kernel = std::max(0.0, d.y) * std::max(0.0, -dot(lamp.normal(), d)) / (pi * distance * distance);
        Line ray = {point, d};
        ray.t_max = 1.0;
        const double value = occluders.closest_hit(ray) ? 0.0 : lamp.area() * kernel;
        sum += value;
        square += value * value;
    }
    const double mean = sum / rays;
    return {mean, std::sqrt((square / rays - mean * mean) / rays)};
}

} // namespace

// Nothing, one sheet, two that overlap, a triangle, a sheet behind the lamp, and one that dips below the floor.
TEST_CASE("the light past blockers is what shadow rays find")
{
    const Surface level = quad({-0.3, 1.0, -0.3}, {0.5, 0, 0}, {0, 0, 0.4});
    const Surface tilted = quad({0.0, 0.8, -0.2}, {0.4, 0.3, 0.1}, {-0.1, 0.2, 0.5});
    const Surface triangle = {Shape::triangle, {-0.4, 1.4, 0.0}, {0.5, 0.1, 0.0}, {0.1, -0.2, 0.4}};
    const Surface behind = quad({-0.5, 2.5, -0.5}, {1, 0, 0}, {0, 0, 1});
    const Surface dipping = quad({0.25, -0.5, -0.5}, {0, 2.0, 0}, {0, 0, 1});
    const std::vector<std::vector<Surface>> settings = {
        {}, {level}, {level, tilted}, {triangle, level}, {behind}, {dipping}, {dipping, tilted, triangle}};
    std::uint64_t key = 1;
    for (const std::vector<Surface>& blockers : settings)
        for (const double x : {-0.7, -0.2, 0.1, 0.6})
            for (const double z : {-0.5, 0.05, 0.4}) {
                const Vec3 point = {x, 0.0, z};
                const Estimate expected = sampled(blockers, point, ++key);
                const double found = irradiance_past(blockers, lamp, point, up);
                CAPTURE(key);
                CHECK(std::abs(found - expected.mean) <= 4.5 * expected.standard_error + 1e-12); // of 84
            }
}

TEST_CASE("a lamp that looks away, or lies below the horizon, gives nothing")
{
    CHECK(irradiance_past({}, lamp, {0, 3, 0}, {0, -1, 0}) == 0.0);
    CHECK(irradiance_past({}, lamp, {0, 0, 0}, {0, -1, 0}) == 0.0);
}

} // namespace occluded_lamp_test
