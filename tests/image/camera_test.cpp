#include "image/camera.h"

#include "base/elementary.h"
#include "base/errors.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <cmath>

namespace camera_test {

using namespace multipath;

namespace {

constexpr double rounding = 1e-14; // a handful of operations on numbers near one

const Camera oblique = {{1.0, 2.0, 3.0}, {4.0, 1.0, -2.0}, {0.0, 1.0, 0.0}, 50.0};

double angle_in_degrees(Vec3 a, Vec3 b)
{
    return std::atan2(length(cross(a, b)), dot(a, b)) * 180.0 / pi;
}

} // namespace

TEST_CASE("the middle of the picture looks at the target")
{
    const Line ray = PixelRays(oblique, 640, 480).through(320.0, 240.0);
    CHECK(ray.origin == oblique.eye);
    CHECK(length(ray.direction - normalized(oblique.target - oblique.eye)) < rounding);
}

TEST_CASE("the vertical field of view is the angle between the middles of the upper and lower border")
{
    const PixelRays rays(oblique, 640, 480);
    CHECK(angle_in_degrees(rays.through(320.0, 0.0).direction, rays.through(320.0, 480.0).direction) ==
          doctest::Approx(50.0).epsilon(1e-12));
}

// Pixels are square, so the tangents of half the angles are as width to height.
TEST_CASE("the horizontal field of view follows from the picture's shape")
{
    const PixelRays rays(oblique, 640, 480);
    const double horizontal =
        angle_in_degrees(rays.through(0.0, 240.0).direction, rays.through(640.0, 240.0).direction);
    CHECK(std::tan(horizontal * pi / 360.0) ==
          doctest::Approx(640.0 / 480.0 * std::tan(25.0 * pi / 180.0)).epsilon(1e-12));
}

TEST_CASE("right is right and up is up")
{
    const PixelRays rays({{0.0, 0.0, 5.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 90.0}, 100, 100);
    CHECK(length(rays.through(100.0, 50.0).direction - normalized({1.0, 0.0, -1.0})) < rounding);
    CHECK(length(rays.through(50.0, 0.0).direction - normalized({0.0, 1.0, -1.0})) < rounding);
}

TEST_CASE("a camera that has no picture is refused")
{
    const Vec3 eye = {1.0, 2.0, 3.0};
    const Vec3 target = {1.0, 5.0, 3.0};
    const Vec3 up = {0.0, 1.0, 0.0};
    CHECK_THROWS_AS(PixelRays({eye, eye, up, 60.0}, 10, 10), SettingsError);
    CHECK_THROWS_AS(PixelRays({eye, target, up, 60.0}, 10, 10), SettingsError);
    CHECK_THROWS_AS(PixelRays({eye, target, {0.0, 0.0, 0.0}, 60.0}, 10, 10), SettingsError);
    CHECK_THROWS_AS(PixelRays({eye, target, {0.0, 0.0, std::nan("")}, 60.0}, 10, 10), SettingsError);
    for (const double angle : {0.0, -10.0, 180.0, std::nan("")})
        CHECK_THROWS_AS(PixelRays({eye, {0.0, 0.0, 0.0}, up, angle}, 10, 10), SettingsError);
    CHECK_THROWS_AS(PixelRays(oblique, 0, 10), SettingsError);
    CHECK_THROWS_AS(PixelRays(oblique, 10, 100000), SettingsError);
    CHECK_THROWS_AS(PixelRays({{1e300, 0.0, 0.0}, target, up, 60.0}, 10, 10), SettingsError);
}

TEST_CASE("a cropped picture shows the middle rows of the whole one")
{
    const Camera camera = {{1.0, 2.0, 3.0}, {0.0, 0.5, 0.0}, {0.0, 1.0, 0.0}, 70.0};
    const PixelRays whole(camera, 320, 240);
    const PixelRays middle(cropped(camera, 240, 200), 320, 200);
    for (const double x : {0.0, 100.0, 320.0})
        for (const double y : {0.0, 37.5, 200.0}) {
            const Vec3 difference = middle.through(x, y).direction - whole.through(x, y + 20.0).direction;
            CHECK(length(difference) < 1e-14); // rounding
        }
}

// Along z the walls of a room from -2 to 2 and of a box from -1 to 1 are met at these parameters.
TEST_CASE("the first front along a ray is seen, whatever backs come before it")
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 1.0);
    builder.room({-2, -2, -2}, {2, 2, 2}, paint).box({-1, -1, -1}, {1, 1, 1}, paint);
    const Line from_outside = {{0.1, 0.2, 5.0}, {0.0, 0.0, -1.0}};
    const Line from_inside_box = {{0.1, 0.2, 0.0}, {0.0, 0.0, -1.0}};
    const Scene scene = builder.scene(1.0);
    const Line between = {{1.5, 0.2, 0.0}, {1.0, 0.0, 0.0}};
    VisibleHits visible(scene);
    const std::vector<std::optional<Hit>> hits =
        visible.first({from_outside, from_inside_box, between, {{0.0, 0.0, 5.0}, {0.0, 0.0, 1.0}}});
    CHECK(hits[0]->t == doctest::Approx(4.0)); // through the room's back to the box
    CHECK(hits[1]->t == doctest::Approx(2.0)); // through the box's back to the room
    CHECK(hits[2]->t == doctest::Approx(0.5)); // no back
    CHECK(!hits[3]);
    CHECK(visible.nearest()[0].t == doctest::Approx(3.0));
    CHECK(visible.nearest()[1].t == doctest::Approx(1.0));

    const Scene two_sided = builder.scene(1.0, true);
    const std::optional<Hit> back = VisibleHits(two_sided).first({from_outside})[0];
    CHECK(back->t == doctest::Approx(3.0));
    CHECK(!back->front);
}

} // namespace camera_test
