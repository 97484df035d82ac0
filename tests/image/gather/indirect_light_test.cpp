#include "image/gather/indirect_light.h"

#include "base/elementary.h"
#include "geometry/intersector/intersector.h"
#include "geometry/polygon.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <optional>

namespace indirect_light_test {

using namespace multipath;

namespace {

Rgb grey(double value)
{
    return {value, value, value};
}

IndirectSample sample_at(const IndirectLight& light, const GatherPoint& receiver)
{
    RayFan fan;
    return light.at(receiver, *make_sequence("sobol-owen", 1), 0, fan);
}

const GatherPoint floor_place = {0, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};

} // namespace

// The closed form of two parallel squares as in the test of SourceLight: 0.239456 at their middles for distance 1. The
// upper one emits as well, which is not to be counted here.
TEST_CASE("indirect light is what a patch reflects times its form factor, without what it emits")
{
    SceneBuilder builder;
    builder.rectangle({-0.1, 0.0, -0.1}, {0.0, 0.0, 0.2}, {0.2, 0.0, 0.0}, builder.grey(0.5, 0.0));
    builder.rectangle({-0.5, 1.0, -0.5}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, builder.grey(0.5, 10.0));
    const Scene scene = builder.scene(1.0);
    const IndirectLight light(scene, {grey(0.0), grey(13.0)}, 4096, 1);
    // The outline crosses about the root of the number of the strata: 4 of the resulting errors.
    CHECK(sample_at(light, floor_place).irradiance.g ==
          doctest::Approx(3.0 * 0.239456).epsilon(4.0 * std::pow(4096.0, -0.75) / 0.239456));
}

// A lamp with a wall along its edge, of which the solution knows nothing. Where rays are shorter than the wall's patch
// is wide, the wall's light must be found nevertheless: its reflectance times the closed form of the lamp's irradiance,
// integrated here by the midpoint rule. The lamp reflects nothing.
TEST_CASE("light from near patches is gathered anew and not looked up if the direct light is given")
{
    SceneBuilder builder;
    builder.rectangle({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, builder.grey(0.0, 10.0));
    builder.rectangle({0.0, 0.0, 0.0}, {0.0, 0.5, 0.0}, {0.0, 0.0, 1.0}, builder.grey(0.5, 0.0));
    const Scene scene = builder.scene(2.0);
    REQUIRE(scene.patch_count() == 2);
    const SourceLight direct(scene);
    const GatherPoint receiver = {0, {0.1, 0.0, 0.4}, {0.0, 1.0, 0.0}, 0};
    const std::vector<Rgb> unknown = {grey(10.0), grey(0.0)};
    CHECK(sample_at({scene, unknown, 4096, 1}, receiver).irradiance == Rgb{});

    constexpr int rows = 100;
    constexpr double step = 0.5 / rows;
    const Vec3 out = {1.0, 0.0, 0.0}; // normal of the wall
    double expected = 0.0;
    for (int i = 0; i < rows; ++i)
        for (int k = 0; k < 2 * rows; ++k) {
            const Vec3 point = {0.0, (i + 0.5) * step, (k + 0.5) * step};
            const Vec3 way = point - receiver.point;
            const double square = dot(way, way);
            if (square >= 0.5)
                continue;
            const FlatPolygon lamp = part_above_horizon(scene.surfaces()[0], point, out);
            const double reflected = 0.5 * 10.0 * irradiance_from(lamp, point, out);
            expected += reflected * way.y * -way.x / (pi * square * square) * step * step;
        }
    CHECK(sample_at({scene, unknown, 4096, 1, &direct}, receiver).irradiance.r ==
          doctest::Approx(expected).epsilon(0.01));
}

// In a closed room that emits and reflects the same everywhere it makes no difference.
TEST_CASE("light that is gathered anew in a furnace is the light that is looked up")
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.75, 1.0);
    const Scene scene = builder.room({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}, {wall, wall, wall, wall, wall, wall}).scene(1.0);
    const SourceLight direct(scene);
    const std::vector<Rgb> radiosity(scene.patch_count(), grey(4.0));
    const GatherPoint receiver = gather_point(scene, {0.0, 0, 0.3, 0.2, true});
    CHECK(sample_at({scene, radiosity, 1024, 1}, receiver).irradiance.r == doctest::Approx(3.0));
    CHECK(sample_at({scene, radiosity, 1024, 1, &direct}, receiver).irradiance.r == doctest::Approx(3.0));
}

// The same square turned over, as wide as the sky: its back gives light where it is a patch of a two-sided scene.
TEST_CASE("backs give indirect light in two-sided scenes alone")
{
    SceneBuilder builder;
    builder.rectangle({-0.1, 0.0, -0.1}, {0.0, 0.0, 0.2}, {0.2, 0.0, 0.0}, builder.grey(0.5, 0.0));
    builder.rectangle({-1e4, 1.0, -1e4}, {0.0, 0.0, 2e4}, {2e4, 0.0, 0.0}, builder.grey(0.5, 10.0));
    const Scene one_sided = builder.scene(1e5);
    CHECK(sample_at({one_sided, {grey(0.0), grey(13.0)}, 64, 1}, floor_place).irradiance == Rgb{});
    const Scene two_sided = builder.scene(1e5, true); // fronts first
    const IndirectLight light(two_sided, {grey(0.0), grey(13.0), grey(0.0), grey(3.0)}, 64, 1);
    CHECK(sample_at(light, floor_place).irradiance.g == doctest::Approx(3.0));
}

// The harmonic mean of the way to a ceiling at height 1, in cosine-distributed directions: the mean of cos(theta) is
// the integral of 2 cos^2 sin = 2/3, so 1.5; the walls are as good as infinitely far away.
TEST_CASE("the distance of a sample is the harmonic mean of what it sees")
{
    SceneBuilder builder;
    builder.rectangle({-0.1, 0.0, -0.1}, {0.0, 0.0, 0.2}, {0.2, 0.0, 0.0}, builder.grey(0.5, 0.0));
    builder.rectangle({-1e4, 1.0, -1e4}, {2e4, 0.0, 0.0}, {0.0, 0.0, 2e4}, builder.grey(0.5, 1.0));
    const Scene scene = builder.scene(1e5);
    const IndirectSample sample = sample_at({scene, {grey(0.0), grey(1.0)}, 1024, 1}, floor_place);
    CHECK(sample.distance == doctest::Approx(1.5).epsilon(0.01)); // smooth: far below the error of random rays, 0.015
}

TEST_CASE("samples of a grid are shared where they are near, level and turned alike")
{
    IndirectGrid grid(20, 20);
    grid.set(10, 10, {floor_place, {1.0, 2.0, 3.0}, 1.0});
    const auto found = [&](Vec3 point, Vec3 normal, int x) {
        return grid.irradiance({0, point, normal}, x, 10).has_value();
    };
    const Vec3 up = {0.0, 1.0, 0.0};
    CHECK(grid.irradiance({0, {0.1, 0.0, 0.0}, up}, 9, 11) == std::optional<Rgb>(Rgb{1.0, 2.0, 3.0}));
    CHECK(found({0.2, 0.0, 0.0}, up, 12));
    CHECK_FALSE(found({0.3, 0.0, 0.0}, up, 10)); // farther than a quarter of what it sees
    CHECK_FALSE(found({0.0, 0.1, 0.0}, up, 10)); // a step up
    CHECK_FALSE(found({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 10));
    CHECK_FALSE(found({0.0, 0.0, 0.0}, up, 17)); // pixels away
}

TEST_CASE("of two samples the nearer one counts more, and equals give their mean")
{
    IndirectGrid grid(4, 1);
    grid.set(0, 0, {{0, {-0.1, 0.0, 0.0}, {0.0, 1.0, 0.0}}, grey(1.0), 1.0});
    grid.set(2, 0, {{0, {0.1, 0.0, 0.0}, {0.0, 1.0, 0.0}}, grey(3.0), 1.0});
    CHECK(grid.irradiance(floor_place, 1, 0)->r == doctest::Approx(2.0));
    // At 0.05 the weights are 1 - 0.15 / 0.25 = 0.4 and 1 - 0.05 / 0.25 = 0.8.
    CHECK(grid.irradiance({0, {0.05, 0.0, 0.0}, {0.0, 1.0, 0.0}}, 1, 0)->r == doctest::Approx((0.4 + 2.4) / 1.2));
}

// A wide floor, seen from straight above: one pixel is as good as another.
TEST_CASE("samples in every second row and column are enough where nothing is close")
{
    const auto receiver = [](int x, int y) { return GatherPoint{0, {0.01 * x, 0.0, 0.01 * y}, {0.0, 1.0, 0.0}}; };
    for (const double distance : {10.0, 0.1}) { // to what is seen
        IndirectGrid grid(20, 20);
        for (int y = 0; y < 20; y += 2)
            for (int x = 0; x < 20; x += 2)
                grid.set(x, y, {receiver(x, y), grey(2.0), distance});
        const bool is_open = distance > 1.0;
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 20; ++x)
                CHECK(grid.is_supported(receiver(x, y), x, y) == is_open);
        CHECK_FALSE(grid.is_supported({0, {0.09, 0.0, 0.09}, {1.0, 0.0, 0.0}}, 9, 9)); // on a wall
        // Set in between, as by another thread: it does not count where there are enough.
        grid.set(9, 9, {receiver(9, 9), grey(4.0), distance});
        CHECK((grid.irradiance(receiver(9, 9), 9, 9)->r > 2.0 + 1e-9) == !is_open);
    }
}

} // namespace indirect_light_test
