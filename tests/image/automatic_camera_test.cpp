#include "image/automatic_camera.h"

#include "scene/input_error.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <cmath>

namespace automatic_camera_test {

using namespace multipath;

namespace {

constexpr double aspect = 4.0 / 3.0;

/// A long furnished room with a lamp, no two of its sides alike.
SceneBuilder furnished_room()
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    builder.room({0, 0, 0}, {7, 3, 5}, paint);
    builder.box({1.0, 0.0, 1.0}, {2.5, 0.9, 2.0}, paint).box({4.5, 0.0, 3.0}, {5.0, 1.6, 3.4}, paint);
    return builder.rectangle({3.0, 2.9, 2.2}, {1.0, 0, 0}, {0, 0, 0.6}, builder.grey(0.0, 10.0));
}

/// The same surfaces, each point p becoming a + scale * turned(p), where turning takes y to z and z to -y.
Scene moved(const SceneBuilder& builder, double scale, Vec3 offset, bool turned)
{
    const auto turn = [&](Vec3 a) { return scale * (turned ? Vec3{a.x, -a.z, a.y} : a); };
    SceneFile file = builder.file();
    for (Surface& surface : file.surfaces)
        surface = {surface.shape, offset + turn(surface.origin), turn(surface.edge_u), turn(surface.edge_v)};
    return Scene(file, scale);
}

/// A room with a lamp and a pillar.
Scene pillar_room()
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    builder.room({0, 0, 0}, {4, 3, 4}, paint).box({1.8, 0.0, 1.8}, {2.2, 2.0, 2.2}, paint);
    return builder.rectangle({1.5, 2.9, 1.5}, {1, 0, 0}, {0, 0, 1}, builder.grey(0.0, 1.0)).scene(1.0);
}

ViewQuality quality(const Scene& scene, Vec3 eye, Vec3 target)
{
    return view_quality(LitScene(scene), {eye, target, {0, 1, 0}, 60.0}, 4.0 / 3.0, 18);
}

} // namespace

TEST_CASE("the camera of a closed room stands in it, looks down a little, and sees nothing from behind")
{
    const Scene scene = furnished_room().scene(1.0);
    const Camera camera = automatic_camera(scene, aspect);
    const ViewQuality quality = view_quality(LitScene(scene), camera, aspect, 30);
    CHECK(quality.escaped_share == 0.0);
    CHECK(quality.back_share == 0.0);
    CHECK(camera.eye.y > camera.target.y);
    CHECK(camera.field_of_view >= 50.0);
    CHECK(camera.field_of_view <= 75.0);
}

TEST_CASE("an open box is seen through its open side")
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 1.0);
    builder.rectangle({0, 0, 0}, {0, 0, 2}, {2, 0, 0}, paint); // floor
    builder.rectangle({0, 2, 0}, {2, 0, 0}, {0, 0, 2}, paint); // ceiling
    builder.rectangle({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, paint); // back
    builder.rectangle({0, 0, 0}, {0, 2, 0}, {0, 0, 2}, paint); // left
    builder.rectangle({2, 0, 0}, {0, 0, 2}, {0, 2, 0}, paint); // right
    const Camera camera = automatic_camera(builder.scene(1.0), aspect);
    CHECK(camera.eye.z > 2.0);
    CHECK(camera.eye.x == doctest::Approx(1.0));
}

TEST_CASE("the camera moves with the scene, in any unit, anywhere, and with any axis up")
{
    const Camera plain = automatic_camera(furnished_room().scene(1.0), aspect);
    for (const double scale : {1e-3, 1.0, 1e4}) {
        const Vec3 offset = scale * Vec3{-31.0, 17.0, 5.0};
        const Camera away = automatic_camera(moved(furnished_room(), scale, offset, false), aspect);
        CHECK(length(away.eye - (offset + scale * plain.eye)) < 1e-9 * scale); // rounding of coordinates near 30
        CHECK(length(away.target - (offset + scale * plain.target)) < 1e-9 * scale);

        const Camera turned = automatic_camera(moved(furnished_room(), scale, offset, true), aspect, {0, 0, 1});
        CHECK(view_quality(LitScene(moved(furnished_room(), scale, offset, true)), turned, aspect, 18).score ==
              doctest::Approx(view_quality(LitScene(furnished_room().scene(1.0)), plain, aspect, 18).score)
                  .epsilon(0.02));
    }
}

TEST_CASE("a scene that is one flat piece is seen from its front")
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, builder.grey(0.5, 1.0)); // looks along z
    CHECK(automatic_camera(builder.scene(1.0), aspect).eye.z > 0.0);
}

TEST_CASE("a direction up that is none is refused")
{
    const Scene scene = furnished_room().scene(1.0);
    CHECK_THROWS_AS(automatic_camera(scene, aspect, {0, 0, 0}), SettingsError);
    CHECK_THROWS_AS(automatic_camera(scene, aspect, {0, INFINITY, 0}), SettingsError);
}

TEST_CASE("however wide the picture, its sides are not stretched")
{
    const Scene scene = furnished_room().scene(1.0);
    for (const double ratio : {0.5, 1.0, 4.0 / 3.0, 3.0, 10.0}) {
        CAPTURE(ratio);
        const double vertical = automatic_camera(scene, ratio).field_of_view;
        CHECK(vertical > 5.0);
        CHECK(vertical <= 68.0);
        CHECK(2.0 * std::atan(ratio * std::tan(0.5 * vertical * radians_per_degree)) / radians_per_degree < 88.1);
    }
}

TEST_CASE("what has no light is not shown where something else has")
{
    // Two rooms side by side, the larger and richer of them without a lamp.
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    builder.room({0, 0, 0}, {8, 3, 8}, paint).box({2, 0, 2}, {3, 1, 3}, paint).box({5, 0, 4}, {6, 2, 6}, paint);
    builder.room({10, 0, 2}, {14, 3, 6}, paint).rectangle({11, 2.9, 3}, {1, 0, 0}, {0, 0, 1}, builder.grey(0.0, 10.0));
    const Scene scene = builder.scene(1.0);
    std::vector<Rgb> radiosity(scene.patch_count());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        if (scene.patch(i).shape.centre().x > 9.0)
            radiosity[i] = {1.0, 1.0, 1.0};
    const Camera camera = automatic_camera(scene, aspect, {0, 1, 0}, radiosity);
    CHECK(view_quality(LitScene(scene, radiosity), camera, aspect, 30).dark_share < 0.05);
    CHECK(view_quality(LitScene(scene), automatic_camera(scene, aspect), aspect, 30).dark_share == 0.0);
    CHECK(view_quality(LitScene(scene, radiosity), automatic_camera(scene, aspect), aspect, 30).dark_share > 0.2);
}

TEST_CASE("rays that leave the scene are counted, and a view of nothing is worse than any of something")
{
    const Scene scene = pillar_room();
    const ViewQuality nothing = quality(scene, {2, 1, 9}, {2, 1, 20});
    CHECK(nothing.escaped_share == 1.0);
    CHECK(nothing.back_share == 0.0);
    CHECK(nothing.score < quality(scene, {3.8, 1.8, 3.8}, {2, 1, 2}).score);
}

TEST_CASE("from outside a closed room every ray passes a back")
{
    CHECK(quality(pillar_room(), {2, 1.5, 4.1}, {2, 1.5, 0}).back_share == 1.0);
}

TEST_CASE("a view across the room is better than a close look at a wall")
{
    const Scene scene = pillar_room();
    const double across = quality(scene, {0.3, 1.9, 0.3}, {2.5, 1.2, 2.5}).score;
    const double wall = quality(scene, {0.3, 1.9, 0.3}, {0.0, 1.9, 0.31}).score;
    CHECK(across > wall + 0.5); // half of what a view that shows everything could gain
}

// A bare room is the same upside down, but for the floor, which adds up to 0.5 to a view, and the ceiling, which adds
// up to 0.2. Both cameras see enough of the one and nothing of the other.
TEST_CASE("a floor in the picture is worth more than a ceiling")
{
    SceneBuilder builder;
    const Scene scene = builder.room({0, 0, 0}, {4, 3, 4}, builder.grey(0.5, 1.0)).scene(1.0);
    const double down = quality(scene, {2, 1.5, 0.2}, {2, 0, 2.2}).score;
    const double up = quality(scene, {2, 1.5, 0.2}, {2, 3, 2.2}).score;
    CHECK(std::abs(down - up - 0.3) < 0.05); // the cells of the scene are not those of its mirror image
}

} // namespace automatic_camera_test
