#include "image/render.h"

#include "image/automatic_camera.h"
#include "image/false_colour.h"
#include "image/shading/smooth_shading.h"
#include "radiosity/run/solve.h"
#include "scene/daylight.h"
#include "scene/obj/obj_reader.h"
#include "test_scenes.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

namespace render_test {

using namespace multipath;

namespace {

Rgb grey(double value)
{
    return {value, value, value};
}

Scene unit_room()
{
    SceneBuilder builder;
    return builder.room({0, 0, 0}, {1, 1, 1}, builder.grey(0.5, 0.0))
        .box({0.3, 0.1, 0.3}, {0.6, 0.4, 0.6}, builder.grey(0.5, 0.0))
        .rectangle({0.4, 0.99, 0.4}, {0.2, 0, 0}, {0, 0, 0.2}, builder.grey(0.0, 1.0))
        .scene(0.2);
}

/// A square in the plane z = 0 whose front looks along +z, and nothing else.
Scene square(bool two_sided = false)
{
    SceneBuilder builder;
    return builder.rectangle({-0.31, -0.27, 0}, {0.6, 0.05, 0}, {-0.05, 0.6, 0}, builder.grey(0.0, 1.0))
        .scene(1.0, two_sided);
}

std::vector<Rgb> some_radiosity(const Scene& scene)
{
    std::vector<Rgb> radiosity;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        radiosity.push_back({1.0 + i % 7, 2.0 + i % 3, 0.5 * (i % 5)});
    return radiosity;
}

RenderOptions small_picture(Shading shading)
{
    RenderOptions options;
    options.width = 40;
    options.height = 30;
    options.shading = shading;
    return options;
}

double mean_red(const Image& image)
{
    double sum = 0.0;
    for (const Rgb& pixel : image.pixels)
        sum += pixel.r;
    return sum / static_cast<double>(image.pixels.size());
}

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

TEST_CASE("a room of one radiosity fills the picture with it")
{
    const Scene scene = unit_room();
    const std::vector<Rgb> radiosity(scene.patch_count(), grey(2.5));
    for (const Shading shading : {Shading::flat, Shading::smooth}) {
        const Image image = render(scene, radiosity, {{0.1, 0.8, 0.1}, {0.5, 0.5, 0.5}}, small_picture(shading));
        for (const Rgb& pixel : image.pixels)
            CHECK(pixel.r == doctest::Approx(2.5).epsilon(1e-13)); // rounding of sums
    }
}

TEST_CASE("any number of threads draws the same picture")
{
    const Scene scene = unit_room();
    for (const Shading shading : {Shading::flat, Shading::smooth, Shading::gather}) {
        RenderOptions options = small_picture(shading);
        const Camera camera = {{0.1, 0.8, 0.1}, {0.5, 0.5, 0.5}};
        const Image one = render(scene, some_radiosity(scene), camera, options);
        options.threads = 3;
        CHECK(render(scene, some_radiosity(scene), camera, options).pixels == one.pixels);
    }
}

// Seen square on from distance 1 with 90 degrees, the picture shows the plane's [-1, 1]^2, of which the square's share
// is (0.6^2 + 0.05^2) / 4. Antialiasing must keep that area: 1600 pixels x 16 samples, the error sits on the outline
// only.
TEST_CASE("the brightness of a picture is the projected area")
{
    RenderOptions options;
    options.width = options.height = 40;
    options.samples_per_pixel = 16;
    const Image image = render(square(), {grey(1.0)}, {{0, 0, 1}, {0, 0, 0}, {0, 1, 0}, 90.0}, options);
    CHECK(mean_red(image) == doctest::Approx((0.36 + 0.0025) / 4.0).epsilon(0.005));
}

TEST_CASE("the outline of a lamp has intermediate steps when white is said, however bright the lamp")
{
    RenderOptions options;
    options.width = options.height = 40;
    options.white = 1.0;
    const Camera camera = {{0, 0, 1}, {0, 0, 0}, {0, 1, 0}, 90.0};
    CHECK(render(square(), {grey(1e6)}, camera, options).pixels ==
          render(square(), {grey(1.0)}, camera, options).pixels);
}

TEST_CASE("rays that meet nothing are black")
{
    const Image image = render(square(), {grey(1.0)}, {{0, 0, 1}, {0, 0, 5}}, small_picture(Shading::flat));
    CHECK(mean_red(image) == 0.0);
}

TEST_CASE("a back is looked through unless the scene has two sides")
{
    const Camera from_behind = {{0, 0, -1}, {0, 0, 0}};
    CHECK(mean_red(render(square(), {grey(1.0)}, from_behind, small_picture(Shading::flat))) == 0.0);
    const Image seen = render(square(true), {grey(1.0), grey(3.0)}, from_behind, small_picture(Shading::flat));
    CHECK(seen.at(20, 15).r == doctest::Approx(3.0));
}

// The eye stands behind the wall z = 0; what it sees through the wall is what it would see without.
TEST_CASE("a closed room can be seen from outside")
{
    const Scene scene = unit_room();
    const Image image = render(scene, some_radiosity(scene), {{0.5, 0.5, -3.0}, {0.5, 0.5, 0.0}, {0, 1, 0}, 10.0},
                               small_picture(Shading::flat));
    CHECK(std::all_of(image.pixels.begin(), image.pixels.end(), [](const Rgb& pixel) { return pixel.r > 0.0; }));
}

// An edge between two pixels, half a pixel from the middle of each: beyond it lie (1 - 1/2)^2 / 2 = 1/8 of the tent.
// The 20 x 20 samples know an edge to a twentieth of a pixel or better.
TEST_CASE("a pixel's samples have the density of a tent two pixels wide")
{
    SceneBuilder builder;
    const Scene scene =
        builder.rectangle({0, -5, 0}, {5, 0, 0}, {0, 10, 0}, builder.grey(0.0, 1.0)).scene(20.0); // right half
    RenderOptions options;
    options.width = options.height = 8;
    options.samples_per_pixel = 400;
    const Image image = render(scene, {grey(1.0)}, {{0, 0, 1}, {0, 0, 0}, {0, 1, 0}, 90.0}, options);
    const double expected[] = {0.0, 0.0, 0.0, 0.125, 0.875, 1.0, 1.0, 1.0};
    for (int x = 0; x < 8; ++x) {
        CHECK(image.at(x, 4).r == doctest::Approx(expected[x]).epsilon(0.01));
        CHECK(image.at(x, 4).r == image.at(x, 2).r);
    }
}

// The edge rises by two pixels over the whole picture. Samples that share rows would show it in the steps of 3 rows;
// of 9 samples in rows of their own, 6 of 8 shades lie between those.
TEST_CASE("an edge that is almost level has a shade for every sample")
{
    SceneBuilder builder;
    const Scene scene = builder.rectangle({-5, -5.05, 0}, {10, 0.1, 0}, {0, 5, 0}, builder.grey(0.0, 1.0)).scene(20.0);
    RenderOptions options;
    options.width = 200;
    options.height = 8;
    options.samples_per_pixel = 9;
    const double angle = 2.0 * std::atan(0.04) * 180.0 / std::acos(-1.0); // a pixel is 0.01 wide
    const Image image = render(scene, {grey(1.0)}, {{0, 0, 1}, {0, 0, 0}, {0, 1, 0}, angle}, options);
    int shades = 0;
    int between = 0;
    for (const Rgb& pixel : image.pixels) {
        const int ninths = static_cast<int>(std::lround(9.0 * pixel.r));
        shades += ninths > 0 && ninths < 9 ? 1 : 0;
        between += ninths % 3 != 0 ? 1 : 0;
    }
    REQUIRE(shades > 200);
    CHECK(between > shades / 2);
}

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

TEST_CASE("of a model with very many surfaces every pixel shows the smooth values")
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    constexpr int across = 75;
    const auto point = [](int i, int j) { return Vec3{0.1 * i, std::sin(0.2 * i) * std::cos(0.3 * j), 0.1 * j}; };
    for (int i = 0; i < across; ++i)
        for (int j = 0; j < across; ++j) {
            const Vec3 a = point(i, j);
            const Vec3 b = point(i + 1, j + 1);
            builder.triangle(a, point(i, j + 1), point(i + 1, j), paint);
            builder.triangle(b, point(i + 1, j), point(i, j + 1), paint);
        }
    builder.rectangle({3, 4, 3}, {1, 0, 0}, {0, 0, 1}, builder.grey(0.0, 1.0));
    const Scene scene = builder.scene(10.0);
    REQUIRE(scene.surfaces().size() > 10'000);
    const std::vector<Rgb> values = some_radiosity(scene);
    const SmoothShading shading(scene, values, 2);
    const Camera camera = {{-1.0, 2.0, -1.0}, {4.0, 0.0, 4.0}, {0, 1, 0}, 50.0};
    RenderOptions options = small_picture(Shading::smooth);
    options.samples_per_pixel = 1;
    const Image image = render(scene, values, camera, options);
    const PixelRays rays(camera, options.width, options.height);
    VisibleHits visible(scene);
    int met = 0;
    for (int y = 0; y < options.height; ++y)
        for (int x = 0; x < options.width; ++x) {
            const std::optional<Hit> hit = visible.first({rays.through(x + 0.5, y + 0.5)})[0];
            met += hit ? 1 : 0;
            CHECK(image.at(x, y) == (hit ? shading.at(*hit) : Rgb{}));
        }
    CHECK(met > 400);
    options.threads = 3;
    options.samples_per_pixel = 4;
    CHECK(mean_red(render(scene, values, camera, options)) == doctest::Approx(mean_red(image)).epsilon(0.02));
}

namespace {

/// A small piece of ground under a coloured sky.
Scene ground_under_sky()
{
    SceneBuilder builder;
    builder.rectangle({-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, builder.grey(0.5, 0.0));
    SceneFile file = builder.file();
    add_sky(file, {1.0, 2.0, 4.0});
    return Scene(file, 2.0);
}

/// Linear light of one pixel that shows the sky at a height, the sine of the elevation.
Rgb sky_at(const Scene& scene, double height, double scale)
{
    RenderOptions options;
    options.width = options.height = 1;
    const Vec3 ahead = {std::sqrt(1.0 - height * height), height, 0.0};
    const Camera camera = {{0, 0.1, 0}, Vec3{0, 0.1, 0} + ahead, {0, 1, 0}, 0.01};
    const ScreenImage image =
        picture(scene, {{0.5, 1.0, 2.0}, {1, 2, 4}, {1, 2, 4}, {1, 2, 4}, {1, 2, 4}, {1, 2, 4}, {1, 2, 4}}, camera,
                options, {ToneOperator::linear, 0.0, scale});
    return srgb_decoded({image.bytes[0] / 255.0, image.bytes[1] / 255.0, image.bytes[2] / 255.0});
}

} // namespace

// Bytes are rounded to about half a percent of the light, at random.
TEST_CASE("a picture shows the sky brighter towards the horizon, on average over the upper hemisphere as it is")
{
    const Scene scene = ground_under_sky();
    constexpr int heights = 200; // uniform by solid angle
    constexpr double scale = 0.1;
    Rgb sum;
    for (int k = 0; k < heights; ++k) {
        const Rgb here = sky_at(scene, (k + 0.5) / heights * 0.999, scale);
        sum += 1.0 / (scale * heights) * here;
        CHECK(here.b > 2.0 * 0.95 * here.g); // in its colour, up to the rounding of the smallest channel
        CHECK(here.g > 2.0 * 0.95 * here.r);
    }
    CHECK(sum.r == doctest::Approx(1.0).epsilon(0.01));
    CHECK(sum.g == doctest::Approx(2.0).epsilon(0.01));
    CHECK(sum.b == doctest::Approx(4.0).epsilon(0.01));
    CHECK(sky_at(scene, 0.02, scale).b > 1.2 * sky_at(scene, 0.4, scale).b);
    CHECK(sky_at(scene, 0.4, scale).b > 1.2 * sky_at(scene, 0.9, scale).b);
}

TEST_CASE("however long the exposure, the sky keeps its colour")
{
    const Scene scene = ground_under_sky();
    const Rgb shown = sky_at(scene, 0.1, 1e6);
    CHECK(shown.b < 0.9);
    CHECK(shown.b > 0.3);
    CHECK(shown.b == doctest::Approx(4.0 * shown.r).epsilon(0.03)); // bytes
}

TEST_CASE("the gradient of the sky goes with the camera's upward direction")
{
    SceneBuilder builder;
    builder.rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, builder.grey(0.5, 0.0)); // faces z
    SceneFile file = builder.file();
    add_sky(file, {1.0, 2.0, 4.0});
    const Scene scene(file, 2.0);
    const std::vector<Rgb> radiosity(scene.patch_count(), {1.0, 2.0, 4.0});
    const Camera camera = {{0, 0, 0.1}, {0.9, 0, 0.5}, {0, 0, 1}, 50.0};
    const ScreenImage image =
        picture(scene, radiosity, camera, small_picture(Shading::flat), {ToneOperator::linear, 0.0, 0.05});
    const Camera y_up = {{0, 0.1, 0}, {0.9, 0.5, 0}, {0, 1, 0}, 50.0};
    const Scene other = ground_under_sky();
    CHECK(image.bytes ==
          picture(other, radiosity, y_up, small_picture(Shading::flat), {ToneOperator::linear, 0.0, 0.05}).bytes);
}

TEST_CASE("values and plain colours of the sky are exact")
{
    const Scene scene = ground_under_sky();
    std::vector<Rgb> radiosity;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        radiosity.push_back(i == 0 ? grey(0.5) : Rgb{1.0, 2.0, 4.0});
    const std::vector<Rgb> colours(scene.patch_count(), grey(1.0));
    for (const double height : {0.1, 50.0}) { // within the sky and beyond it
        const Camera camera = {{0, height, 0}, {0.9, height + 0.4, 0}, {0, 1, 0}, 50.0};
        for (const Rgb& pixel : render(scene, radiosity, camera, small_picture(Shading::smooth)).pixels)
            CHECK(pixel == Rgb{1.0, 2.0, 4.0});
        const ScreenImage image = flat_picture(scene, colours, camera, small_picture(Shading::flat));
        CHECK(std::all_of(image.bytes.begin(), image.bytes.end(), [](std::uint8_t byte) { return byte == 255; }));
    }
}

} // namespace render_test

namespace final_gather_test {

using namespace multipath;

namespace {

RenderOptions gathered(int width, int height)
{
    RenderOptions options;
    options.width = width;
    options.height = height;
    options.shading = Shading::gather;
    options.samples_per_pixel = 4;
    options.gather_rays = 16;
    return options;
}

double mean_of(const Image& image)
{
    double sum = 0.0;
    for (const Rgb& pixel : image.pixels)
        sum += mean(pixel);
    return sum / static_cast<double>(image.pixels.size());
}

} // namespace

// B = E / (1 - rho) everywhere, from sources in full sight and from patches of one radiosity: nothing is left to
// chance.
TEST_CASE("in the furnace every gathered pixel is E / (1 - rho)")
{
    const Scene scene(read_obj("scenes/furnace.obj"), 0.5);
    const std::vector<Rgb> radiosity(scene.patch_count(), {2.0, 2.0, 2.0});
    const Image image = render(scene, radiosity, {{0.2, 0.7, 0.9}, {0.6, 0.4, 0.1}}, gathered(24, 16));
    for (const Rgb& pixel : image.pixels) {
        CHECK(pixel.r == doctest::Approx(2.0).epsilon(1e-9)); // rounding, also of Lambert's formula close to a wall
        CHECK(pixel.g == doctest::Approx(2.0).epsilon(1e-9));
        CHECK(pixel.b == doctest::Approx(2.0).epsilon(1e-9));
    }
}

// A spot of floor that reflects 0.8 below a square of 1 m^2 at distance 1 m: rho E F with F = 0.239456 (Howell B-3,
// four times a = b = 0.5). The camera looks down at it from the side.
TEST_CASE("a gathered pixel shows the closed form of the irradiance from a facing square")
{
    SceneBuilder builder;
    builder.rectangle({-1.0, 0.0, -1.0}, {0.0, 0.0, 2.0}, {2.0, 0.0, 0.0}, builder.grey(0.8, 0.0));
    builder.rectangle({-0.5, 1.0, -0.5}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, builder.grey(0.0, 5.0));
    const Scene scene = builder.scene(2.0);
    std::vector<Rgb> radiosity(scene.patch_count());
    radiosity[scene.first_patch(1)] = {5.0, 5.0, 5.0};
    const Camera camera = {{1.5, 0.9, 0.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 1e-3};
    const Image image = render(scene, radiosity, camera, gathered(1, 1));
    CHECK(image.at(0, 0).g == doctest::Approx(0.8 * 5.0 * 0.239456).epsilon(1e-5)); // the pixel has a width
}

// Gathering moves light about within patches but neither adds nor loses any: counting the lamp twice, for example,
// would nearly double the mean.
TEST_CASE("the mean of a gathered picture is that of the plain patches")
{
    const Scene scene(read_obj("scenes/5cubes.obj"), 0.2);
    SolveOptions solving;
    solving.method = Method::reuse;
    solving.lines = 1u << 18;
    const std::vector<Rgb> radiosity = solve(scene, solving, [](double) {}).radiosity;
    const Camera camera = automatic_camera(scene, 4.0 / 3.0);
    RenderOptions options = gathered(64, 48);
    const double gathered_mean = mean_of(render(scene, radiosity, camera, options));
    options.shading = Shading::flat;
    const double flat_mean = mean_of(render(scene, radiosity, camera, options));
    // 3072 pixels of 16 rays leave 0.1 %; that patches cannot follow the light between them makes 0.3 %.
    CHECK(gathered_mean == doctest::Approx(flat_mean).epsilon(0.01));
}

// Light of the sources that has been reflected once: E + rho E, whatever the patches say.
TEST_CASE("without indirect light the furnace shows E (1 + rho)")
{
    const Scene scene(read_obj("scenes/furnace.obj"), 0.5);
    RenderOptions options = gathered(12, 8);
    options.indirect = false;
    const std::vector<Rgb> radiosity(scene.patch_count(), {2.0, 2.0, 2.0});
    for (const Rgb& pixel : render(scene, radiosity, {{0.2, 0.7, 0.9}, {0.6, 0.4, 0.1}}, options).pixels) {
        CHECK(pixel.r == doctest::Approx(1.5 * 1.25).epsilon(1e-9)); // rounding
        CHECK(pixel.b == doctest::Approx(0.5 * 1.75).epsilon(1e-9));
    }
}

} // namespace final_gather_test
