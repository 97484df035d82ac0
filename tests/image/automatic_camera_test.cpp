#include "image/automatic_camera.h"

#include "base/errors.h"
#include "geometry/polygon.h"
#include "image/view_quality.h"
#include "scene/daylight.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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

/// A flat of two rooms without a door. Only the left one has light, but for a thousandth that leaks.
struct Flat
{
    Scene scene;
    std::vector<Rgb> radiosity;
};

Flat flat_with_dark_room()
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    builder.room({0, 0, 0}, {6, 2.6, 4}, paint).box({2.95, 0, 0}, {3.05, 2.6, 4}, paint);
    builder.box({4.2, 0, 1.2}, {5.2, 0.7, 2.2}, paint);
    builder.rectangle({1, 2.59, 1.5}, {0.6, 0, 0}, {0, 0, 0.6}, builder.grey(0.5, 20.0));
    const Scene scene = builder.scene(0.3);
    std::vector<Rgb> radiosity;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const double light = scene.patch(i).shape.centre().x < 3.0 ? 1.0 : 1e-3;
        radiosity.push_back(scene.emittance(i) + Rgb{light, light, light});
    }
    return {scene, radiosity};
}

/// A tall open court with a bench, and walls of some thickness.
SceneBuilder court()
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    builder.rectangle({-1, 0, -1}, {0, 0, 11}, {14, 0, 0}, paint).box({5, 0, 4}, {7, 0.5, 5}, paint);
    builder.box({-1, 0, -1}, {0, 5, 10}, paint).box({12, 0, -1}, {13, 5, 10}, paint);
    return builder.box({0, 0, -1}, {12, 5, 0}, paint).box({0, 0, 9}, {12, 5, 10}, paint);
}

/// A long house in a wide meadow.
SceneBuilder house()
{
    SceneBuilder builder;
    builder.rectangle({-30, 0, -20}, {0, 0, 50}, {70, 0, 0}, builder.grey(0.4, 0.0));
    return builder.box({0, 0, 0}, {9, 4, 3}, builder.grey(0.6, 0.0));
}

Scene under_sky(const SceneBuilder& builder, Vec3 offset = {})
{
    SceneFile file = builder.file();
    for (Surface& surface : file.surfaces)
        surface.origin = surface.origin + offset;
    add_sky(file, {5.0, 5.0, 5.0});
    return Scene(file, 0.5);
}

/// Radiosity as if every surface saw the whole sky, and brighter on the sides that look along `sun`.
std::vector<Rgb> daylight_on(const Scene& scene, Vec3 sun)
{
    std::vector<Rgb> radiosity;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const double light = 5.0 + 30.0 * std::max(0.0, dot(scene.patch(i).shape.normal(), sun));
        radiosity.push_back(scene.emittance(i) + light * scene.reflectance(i));
    }
    return radiosity;
}

/// The place of a point in the picture: x and y are between -1 and 1 if the picture shows it.
struct Place
{
    double x;
    double y;
};

Place place_in_picture(const Camera& camera, Vec3 point)
{
    const Vec3 ahead = normalized(camera.target - camera.eye);
    const Vec3 right = normalized(cross(ahead, camera.up));
    const Vec3 way = point - camera.eye;
    const double half = std::tan(0.5 * camera.field_of_view * radians_per_degree) * dot(way, ahead);
    return {dot(way, right) / (half * aspect), dot(way, cross(right, ahead)) / half};
}

/// An exchange of axes, which may turn the scene into its mirror image.
struct Axes
{
    Vec3 x, y, z; ///< what the axes become

    Vec3 operator()(Vec3 p) const { return p.x * x + p.y * y + p.z * z; }
    bool mirrors() const { return dot(cross(x, y), z) < 0.0; }
};

/// All exchanges of axes with changes of sign: 48.
std::vector<Axes> all_axes()
{
    const Vec3 unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    std::vector<Axes> result;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int signs = 0; i != j && signs < 8; ++signs)
                result.push_back({(signs & 1 ? -1.0 : 1.0) * unit[i], (signs & 2 ? -1.0 : 1.0) * unit[j],
                                  (signs & 4 ? -1.0 : 1.0) * unit[3 - i - j]});
    return result;
}

SceneFile exchanged(SceneFile file, const Axes& axes)
{
    for (Surface& surface : file.surfaces) {
        surface = {surface.shape, axes(surface.origin), axes(surface.edge_u), axes(surface.edge_v)};
        if (axes.mirrors())
            std::swap(surface.edge_u, surface.edge_v);
    }
    return file;
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

// What a lamp emits says nothing of what is lit.
TEST_CASE("walls count as lit however little they reflect of the light")
{
    const Scene scene = pillar_room();
    for (const double reflected : {0.5, 1e-3, 1e-5}) {
        std::vector<Rgb> radiosity;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            radiosity.push_back(scene.emittance(i) + Rgb{reflected, 0.5 * reflected, 2.0 * reflected});
        const std::vector<bool> is_lit = LitScene(scene, radiosity).is_lit;
        CHECK(std::count(is_lit.begin(), is_lit.end(), false) == 0);
    }
}

TEST_CASE("a flat with a dark room is seen from within its lit room")
{
    const Flat flat = flat_with_dark_room();
    const Camera camera = automatic_camera(flat.scene, aspect, {0, 1, 0}, flat.radiosity);
    for (const auto& [x, low, high] : {std::array{camera.eye.x, 0.0, 2.95}, std::array{camera.eye.y, 0.0, 2.6},
                                       std::array{camera.eye.z, 0.0, 4.0}}) {
        CHECK(x > low);
        CHECK(x < high);
    }
    const ViewQuality quality = view_quality(LitScene(flat.scene, flat.radiosity), camera, aspect, 30);
    CHECK(quality.dark_share == 0.0);
    CHECK(quality.unexposed_share == 0.0);
    CHECK(quality.is_good());
}

// Both halves in one picture: whatever the exposure, one of them is lost.
TEST_CASE("a view of a lit and a dark room at once is not good")
{
    const Flat flat = flat_with_dark_room();
    const LitScene lit(flat.scene, flat.radiosity);
    const Camera both = {{3, 1.6, -2.5}, {3, 1.2, 2}, {0, 1, 0}, 60.0};
    CHECK(view_quality(lit, both, aspect, 30).unexposed_share > 0.3);
    CHECK_FALSE(view_quality(lit, both, aspect, 30).is_good());
}

TEST_CASE("a view past something that fills much of the picture is not good")
{
    const Scene scene = furnished_room().scene(1.0);
    const ViewQuality hidden =
        view_quality(LitScene(scene), {{3.5, 2.7, 2.5}, {2.5, 3, 2.5}, {0, 1, 0}, 80.0}, aspect, 18);
    CHECK(hidden.in_the_way_share > 0.4);
    CHECK_FALSE(hidden.is_good());
}

TEST_CASE("under a sky a court is seen from within, and a house from outside")
{
    for (const Vec3 offset : {Vec3{}, Vec3{20, 70, -5}, Vec3{-3, -40, 8}}) {
        const Scene walls = under_sky(court(), offset);
        const std::vector<Rgb> light = daylight_on(walls, {0, 1, 0});
        const Vec3 within = automatic_camera(walls, aspect, {0, 1, 0}, light).eye - offset;
        CHECK(overlap(Bounds{{0, 0, 0}, {12, 5, 9}}, Bounds{within, within}));
    }
    const Scene home = under_sky(house());
    const Vec3 outside = automatic_camera(home, aspect, {0, 1, 0}, daylight_on(home, {0, 1, 0})).eye;
    CHECK_FALSE(overlap(Bounds{{0, 0, 0}, {9, 4, 3}}, Bounds{outside, outside}));
    CHECK(outside.y > 0.0);
}

// 1 / 1.1 of the picture, since the camera keeps a tenth of the distance as a margin; less in the middle of a
// perspective, since the distance is measured from the centre of the house.
TEST_CASE("outdoors the picture holds all that rises above the ground, and not much more")
{
    const Scene scene = under_sky(house());
    const Camera camera = automatic_camera(scene, aspect, {0, 1, 0}, daylight_on(scene, {0, 1, 0}));
    double farthest = 0.0;
    for (std::uint32_t s = 1; s < scene.own_surfaces(); ++s)
        for (const Vec3 corner : corners_of(scene.surfaces()[s])) {
            const Place place = place_in_picture(camera, corner);
            farthest = std::max({farthest, std::abs(place.x), std::abs(place.y)});
        }
    CHECK(farthest < 1.0);
    CHECK(farthest > 0.8);
}

TEST_CASE("outdoors the camera stands on the sunny side")
{
    const Scene scene = under_sky(house());
    for (const double side : {1.0, -1.0}) {
        const Vec3 sun = normalized({0.0, 0.5, side});
        const Camera camera = automatic_camera(scene, aspect, {0, 1, 0}, daylight_on(scene, sun));
        CHECK(side * (camera.eye.z - 1.5) > 0.0);
    }
}

// The candidates of a scene and of its image are images of each other, and so are their pictures. Only the cells that
// measure the variety are not, since they are counted from one corner of the scene, nor the points from which a court
// is measured. So another candidate may win whose score is nearly as good: up to some 40 cells of 432 rays, a tenth.
TEST_CASE("a scene with its axes exchanged is seen as well, from as far away")
{
    SceneBuilder open; // a box of three different sizes whose side at z = 3 is open
    const std::uint32_t paint = open.grey(0.5, 1.0);
    open.rectangle({0, 0, 0}, {0, 0, 3}, {8, 0, 0}, paint).rectangle({0, 2, 0}, {8, 0, 0}, {0, 0, 3}, paint);
    open.rectangle({0, 0, 0}, {8, 0, 0}, {0, 2, 0}, paint).rectangle({0, 0, 0}, {0, 2, 0}, {0, 0, 3}, paint);
    open.rectangle({8, 0, 0}, {0, 0, 3}, {0, 2, 0}, paint);
    struct Case
    {
        SceneFile file;
        bool sky;
    };
    for (const Case& c : {Case{open.file(), false}, Case{furnished_room().file(), false}, Case{court().file(), true},
                          Case{house().file(), true}}) {
        const auto seen = [&](const Axes& axes) {
            SceneFile file = exchanged(c.file, axes);
            if (c.sky)
                add_sky(file, {5.0, 5.0, 5.0});
            const Scene scene(file, 0.5);
            const std::vector<Rgb> light = daylight_on(scene, axes.y);
            const std::vector<Rgb> radiosity = c.sky ? light : std::vector<Rgb>{};
            const Camera camera = automatic_camera(scene, aspect, axes.y, radiosity);
            const double score = view_quality(LitScene(scene, radiosity), camera, aspect, 18).score;
            return std::pair{score, length(camera.eye - scene.own_bounds().centre())};
        };
        const auto [score, distance] = seen({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
        for (const Axes& axes : all_axes()) {
            const auto [other_score, other_distance] = seen(axes);
            CHECK(other_score == doctest::Approx(score).epsilon(0.05));
            if (!c.sky && c.file.surfaces.size() == 5) // one candidate is the best by far
                CHECK(other_distance == doctest::Approx(distance).epsilon(1e-9));
        }
    }
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
