#include "image/exposure.h"

#include "scene/daylight.h"
#include "scene/scene_builder.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace exposure_test {

using namespace multipath;

namespace {

RenderOptions small_picture()
{
    RenderOptions options;
    options.width = 80;
    options.height = 60;
    return options;
}

/// A room whose wall at z = 4 has a window, before it a meadow and a house.
Scene room_with_view()
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    builder.box({-0.3, -0.2, -0.3}, {5.3, 2.9, 0.0}, paint).box({-0.3, -0.2, 0}, {0, 2.9, 4.3}, paint);
    builder.box({5, -0.2, 0}, {5.3, 2.9, 4.3}, paint).box({0, -0.2, 0}, {5, 0, 4.3}, paint);
    builder.box({0, 2.7, 0}, {5, 2.9, 4.3}, paint).box({0, 0, 4}, {1, 2.7, 4.3}, paint);
    builder.box({4, 0, 4}, {5, 2.7, 4.3}, paint).box({1, 0, 4}, {4, 0.8, 4.3}, paint);
    builder.box({1, 2.3, 4}, {4, 2.7, 4.3}, paint).box({-2, -0.2, 15}, {7, 4, 20}, paint);
    builder.rectangle({-9, -0.2, 4.3}, {0, 0, 20}, {20, 0, 0}, paint);
    SceneFile file = builder.file();
    add_sky(file, {1.0, 1.0, 1.0});
    return Scene(file, 0.5);
}

/// Radiosity 1 indoors, and others outdoors and of the sky.
std::vector<Rgb> radiosity_of(const Scene& scene, double outdoors, double sky)
{
    std::vector<Rgb> radiosity;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const double light = scene.is_sky(scene.surface_of(i))              ? sky
                             : scene.patch(i).shape.centre().z > 4.0 + 1e-9 ? outdoors
                                                                            : 1.0;
        radiosity.push_back({light, light, light});
    }
    return radiosity;
}

double scale_of(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera, ToneOperator tone)
{
    return automatic_exposure(scene, radiosity, camera, small_picture(), tone);
}

} // namespace

// Indoors every pixel of the middle half has radiosity 1, however bright the day.
TEST_CASE("what a window shows has no influence on the exposure of a room")
{
    const Scene scene = room_with_view();
    const Camera camera = {{2.5, 1.4, 0.3}, {2.5, 1.4, 4.0}, {0, 1, 0}, 60.0};
    for (const NamedToneOperator& named : tone_operators) {
        CAPTURE(named.name);
        const double scale = scale_of(scene, radiosity_of(scene, 1.0, 1.0), camera, named.tone);
        CHECK(scale_of(scene, radiosity_of(scene, 1e4, 1e5), camera, named.tone) == doctest::Approx(scale));
        CHECK(scale_of(scene, radiosity_of(scene, 1e-4, 0.0), camera, named.tone) == doctest::Approx(scale));
    }
}

TEST_CASE("outdoors the exposure is that of all but the sky")
{
    const Scene scene = room_with_view();
    const Camera camera = {{2.5, 1.5, 5.0}, {2.5, 1.5, 15.0}, {0, 1, 0}, 60.0};
    const double scale = scale_of(scene, radiosity_of(scene, 1.0, 1.0), camera, ToneOperator::reinhard);
    CHECK(scale_of(scene, radiosity_of(scene, 4.0, 1e6), camera, ToneOperator::reinhard) ==
          doctest::Approx(scale / 4.0));
}

TEST_CASE("a picture of nothing but the view from a window is exposed for the view")
{
    const Scene scene = room_with_view();
    const Camera camera = {{2.5, 1.5, 3.5}, {2.5, 1.5, 15.0}, {0, 1, 0}, 30.0};
    const double scale = scale_of(scene, radiosity_of(scene, 1.0, 1.0), camera, ToneOperator::reinhard);
    CHECK(scale_of(scene, radiosity_of(scene, 4.0, 1.0), camera, ToneOperator::reinhard) ==
          doctest::Approx(scale / 4.0));
}

// A room of two halves, of which one is a thousand times brighter: the mean exposure would clip it.
TEST_CASE("of the surfaces in a picture no more than an eighth is white")
{
    SceneBuilder builder;
    builder.room({0, 0, 0}, {4, 3, 3}, builder.grey(0.5, 0.0));
    builder.rectangle({1, 2.9, 1}, {0.1, 0, 0}, {0, 0, 0.1}, builder.grey(0.5, 1.0));
    const Scene scene = builder.scene(0.5);
    std::vector<Rgb> radiosity;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const double light = scene.patch(i).shape.centre().x < 2.0 ? 1.0 + 1e-3 * (i % 100) : 1000.0 + 20.0 * (i % 100);
        radiosity.push_back({light, light, light});
    }
    const Camera camera = {{2.0, 1.5, 0.1}, {2.0, 1.5, 3.0}, {0, 1, 0}, 60.0};
    for (const NamedToneOperator& named : tone_operators) {
        CAPTURE(named.name);
        RenderOptions flat = small_picture(); // the preview itself, pixel by pixel
        flat.shading = Shading::flat;
        flat.samples_per_pixel = 1;
        const double scale = picture_scale(scene, radiosity, camera, flat, {named.tone});
        const Image image = render(scene, radiosity, camera, flat);
        const auto white = std::count_if(image.pixels.begin(), image.pixels.end(), [&](Rgb pixel) {
            return screen_light((1.0 - 1e-9) * pixel, named.tone, scale).r >= 1.0; // one pixel is white up to rounding
        });
        CHECK(static_cast<double>(white) <= 0.125 * static_cast<double>(image.pixels.size()));
    }
}

TEST_CASE("the exposure does not depend on the number of threads")
{
    const Scene scene = room_with_view();
    const std::vector<Rgb> radiosity = radiosity_of(scene, 30.0, 100.0);
    const Camera camera = {{1.0, 1.4, 0.3}, {3.5, 1.4, 4.0}, {0, 1, 0}, 70.0};
    RenderOptions several = small_picture();
    several.threads = 3;
    CHECK(automatic_exposure(scene, radiosity, camera, several, ToneOperator::reinhard) ==
          scale_of(scene, radiosity, camera, ToneOperator::reinhard));
}

} // namespace exposure_test
