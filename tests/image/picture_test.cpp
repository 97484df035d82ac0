#include "image/picture.h"

#include "test_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace picture_test {

using namespace multipath;

namespace {

/// A room with a lamp below the ceiling.
Scene room_with_lamp()
{
    SceneBuilder builder;
    builder.room({0, 0, 0}, {3, 3, 3}, builder.grey(0.5, 0.0));
    return builder.rectangle({1, 2.8, 1}, {1, 0, 0}, {0, 0, 1}, builder.grey(0.0, 1.0)).scene(1.0);
}

std::vector<Rgb> radiosity(const Scene& scene, double room, double lamp)
{
    std::vector<Rgb> values;
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch) {
        const double value = scene.emittance(patch) == Rgb{} ? room : lamp;
        values.push_back({value, value, value});
    }
    return values;
}

ScreenImage shown(const Scene& scene, const std::vector<Rgb>& values, double exposure)
{
    RenderOptions options;
    options.width = 64;
    options.height = 48;
    return picture(scene, values, {{0.1, 1.0, 0.1}, {2.0, 2.0, 2.0}, {0, 1, 0}, 70.0}, options,
                   {ToneOperator::reinhard, exposure});
}

long count_of(const ScreenImage& image, int low, int high)
{
    return std::count_if(image.bytes.begin(), image.bytes.end(),
                         [&](std::uint8_t byte) { return byte >= low && byte <= high; });
}

} // namespace

// The encoded value of the middle grey, 0.24, is byte 134.
TEST_CASE("the room is shown in a middle grey, its lamp white")
{
    const Scene scene = room_with_lamp();
    const ScreenImage image = shown(scene, radiosity(scene, 0.01, 30.0), 0.0);
    CHECK(count_of(image, 133, 135) > 3 * 64 * 48 / 2);
    CHECK(count_of(image, 255, 255) > 3 * 20);
    CHECK(count_of(image, 0, 132) == 0);
}

TEST_CASE("a lamp of any strength gives the same picture, outline included")
{
    const Scene scene = room_with_lamp();
    CHECK(shown(scene, radiosity(scene, 1.0, 1e3), 0.0).bytes == shown(scene, radiosity(scene, 1.0, 1e7), 0.0).bytes);
}

TEST_CASE("exposure brightens the room")
{
    const Scene scene = room_with_lamp();
    const std::vector<Rgb> values = radiosity(scene, 1.0, 1e3);
    CHECK(count_of(shown(scene, values, 1.0), 0, 135) == 0);
    CHECK(count_of(shown(scene, values, -1.0), 133, 135) < 3 * 20);
}

TEST_CASE("the scale of a picture is the one it is shown with")
{
    const Scene scene = room_with_lamp();
    const std::vector<Rgb> values = radiosity(scene, 3.0, 100.0);
    const Camera camera = {{0.1, 1.0, 0.1}, {2.0, 2.0, 2.0}, {0, 1, 0}, 70.0};
    RenderOptions options;
    options.width = 64;
    options.height = 48;
    const ToneMapOptions tone = {ToneOperator::reinhard, 0.5};
    const double scale = picture_scale(scene, values, camera, options, tone);
    CHECK(picture(scene, values, camera, options, tone).bytes ==
          picture(scene, values, camera, options, {ToneOperator::reinhard, 0.0, scale}).bytes);
    CHECK(picture_scale(scene, values, camera, options, {ToneOperator::reinhard, 1.0, 3.0}) == 6.0);
}

} // namespace picture_test
