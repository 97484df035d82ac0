#include "selftest/known_scenes.h"

#include "base/elementary.h"
#include "geometry/form_factor/exchange_area.h"
#include "geometry/intersector/intersector.h"
#include "radiosity/run/solve.h"
#include "sampling/random.h"
#include "seeded_runs.h"

#include <cmath>
#include <doctest/doctest.h>
#include <initializer_list>
#include <map>
#include <vector>

namespace known_scenes_test {

using namespace multipath;

namespace {

std::map<std::string, KnownScene> scenes_by_name()
{
    std::map<std::string, KnownScene> scenes;
    for (const KnownScene& scene : known_scenes())
        scenes[scene.name] = scene;
    return scenes;
}

} // namespace

// The formulas of the known scenes are Howell's; the contour integral of the program is another way to the same
// numbers.
TEST_CASE("the exchange of the known rectangles is that of the contour integral")
{
    for (const char* name : {"parallel", "perpendicular"}) {
        CAPTURE(name);
        const KnownScene known = scenes_by_name()[name];
        CHECK(known.answers[0].value ==
              doctest::Approx(exchange_area(known.file.surfaces[0], known.file.surfaces[1], 1e-9)).epsilon(1e-7));
    }
    const KnownScene facing = scenes_by_name()["facing-squares"];
    const double escaping = scenes_by_name()["open-cube"].answers[0].value;
    CHECK(escaping ==
          doctest::Approx(exchange_area(facing.file.surfaces[0], facing.file.surfaces[1], 1e-9)).epsilon(1e-7));
}

// B_o (1 - rho_o (1 - F_oi)) = rho_o F_oi B_i and B_i = 3 + rho_i B_o, with F_oi = 6 * 0.16 / 6.
TEST_CASE("the light between nested cubes balances")
{
    const KnownScene nested = scenes_by_name()["nested-cubes"];
    const double outer = nested.answers[0].value;
    const double inner = nested.answers[1].value;
    CHECK(inner == doctest::Approx(3.0 + 0.6 * outer));
    CHECK(outer == doctest::Approx(0.5 * (0.16 * inner + 0.84 * outer)));
}

// Each surface is one patch, and the answers name patches by number.
TEST_CASE("the most accurate method finds every known answer")
{
    for (const KnownScene& known : known_scenes()) {
        const Scene scene(known.file, 1e3);
        CHECK(scene.patch_count() == known.file.surfaces.size());
        SolveOptions options = random_lines(Method::reuse, 1u << 15, 1);
        options.sequence = "sobol-owen";
        const Solution solution = solve(scene, options, silent);
        CAPTURE(known.name);
        CHECK_MESSAGE(mean(solution.balance.behind) == 0.0,
                      "light meets surfaces from behind; turn those that look away");
        for (const KnownAnswer& answer : known.answers) {
            CAPTURE(answer.quantity);
            CHECK(answer.read(scene, solution) == doctest::Approx(answer.value).epsilon(2e-3));
        }
    }
}

} // namespace known_scenes_test

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
