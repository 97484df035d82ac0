#include "image/false_colour.h"

#include "image/colour_scale.h"
#include "image/tone_map.h"
#include "test_scenes.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <limits>

namespace false_colour_test {

using namespace multipath;

namespace {

/// A room with a small lamp below the ceiling.
Scene room_with_lamp()
{
    SceneBuilder builder;
    builder.room({0, 0, 0}, {3, 3, 3}, builder.grey(0.5, 0.0));
    return builder.rectangle({1.5, 2.9, 1.5}, {0.4, 0, 0}, {0, 0, 0.4}, builder.grey(0.0, 1.0)).scene(1.0);
}

Quantity quantity(const Scene& scene, double room, double lamp)
{
    Quantity result{"radiosity [W/m\xB2]", {}};
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch) {
        const double value = scene.emittance(patch) == Rgb{} ? room : lamp;
        result.values.push_back({value, value, value});
    }
    return result;
}

RenderOptions sized(int width, int height)
{
    RenderOptions options;
    options.width = width;
    options.height = height;
    return options;
}

const Camera inside = {{0.1, 1.0, 0.1}, {2.0, 2.0, 2.0}, {0, 1, 0}, 70.0};

long count_of(const ScreenImage& image, Rgb colour)
{
    long count = 0;
    for (std::size_t i = 0; i < image.bytes.size(); i += 3)
        count += image.bytes[i] == screen_byte(colour.r) && image.bytes[i + 1] == screen_byte(colour.g) &&
                 image.bytes[i + 2] == screen_byte(colour.b);
    return count;
}

} // namespace

// 0.6 is a round number itself, 0.3 of the lamp half of it. The lamp is about 15 pixels, most of them on its edge.
TEST_CASE("a value has the colour of its share of the scale, exactly")
{
    const Scene scene = room_with_lamp();
    const ScreenImage image = false_colour(scene, quantity(scene, 0.6, 0.3), inside, sized(64, 48));
    CHECK(count_of(image, map_colour(1.0)) > 64 * 48 * 9 / 10);
    CHECK(count_of(image, map_colour(0.5)) >= 1);
}

TEST_CASE("the colour is that of the mean of the channels")
{
    const Scene scene = room_with_lamp();
    Quantity coloured = quantity(scene, 0.6, 0.3);
    for (Rgb& value : coloured.values)
        value = value.r == 0.6 ? Rgb{1.2, 0.6, 0.0} : Rgb{0.0, 0.0, 0.9};
    CHECK(false_colour(scene, coloured, inside, sized(64, 48)).bytes ==
          false_colour(scene, quantity(scene, 0.6, 0.3), inside, sized(64, 48)).bytes);
}

TEST_CASE("what fills less than a hundredth of the picture does not set the scale")
{
    const Scene scene = room_with_lamp();
    const ScreenImage image = false_colour(scene, quantity(scene, 0.6, 1e9), inside, sized(64, 48));
    CHECK(count_of(image, map_colour(1.0)) == 64 * 48);
}

TEST_CASE("what has no value is black, and what is zero is not")
{
    const Scene scene = room_with_lamp();
    const double none = std::numeric_limits<double>::quiet_NaN();
    const ScreenImage absent = false_colour(scene, quantity(scene, 0.6, none), inside, sized(64, 48));
    const ScreenImage zero = false_colour(scene, quantity(scene, 0.6, 0.0), inside, sized(64, 48));
    CHECK(count_of(absent, {}) >= 1);
    CHECK(count_of(zero, {}) == 0);
    CHECK(count_of(zero, map_colour(0.0)) == count_of(absent, {}));
    CHECK(count_of(false_colour(scene, quantity(scene, none, none), inside, sized(64, 48)), {}) == 64 * 48);
}

TEST_CASE("a picture of zeros has the colour of zero")
{
    const Scene scene = room_with_lamp();
    const ScreenImage image = false_colour(scene, quantity(scene, 0.0, 0.0), inside, sized(64, 48));
    CHECK(count_of(image, map_colour(0.0)) == 64 * 48);
}

TEST_CASE("the legend is part of the size that was asked for")
{
    const Scene scene = room_with_lamp();
    const Quantity shown = quantity(scene, 0.6, 0.3);
    const int height = legend_height(320, 240, shown.title);
    REQUIRE(height > 0);
    const ScreenImage image = false_colour(scene, shown, inside, sized(320, 240));
    CHECK(image.width == 320);
    CHECK(image.height == 240);
    REQUIRE(image.bytes.size() == 3 * 320 * 240);
    const ScreenImage strip = legend_strip(320, height, {shown.title, round_scale(0.6)});
    CHECK(std::equal(strip.bytes.rbegin(), strip.bytes.rend(), image.bytes.rbegin()));
}

// All pixels but those on the edges of patches, which are a fifth here.
TEST_CASE("each patch keeps its own colour, whatever the shading that was asked for")
{
    const Scene scene = room_with_lamp();
    const std::vector<Rgb> colours = patch_colours(scene.patch_count());
    const ScreenImage image = flat_picture(scene, colours, inside, sized(64, 48)); // smooth
    long of_a_patch = 0;
    for (const Rgb& colour : colours)
        of_a_patch += count_of(image, colour);
    CHECK(of_a_patch > 64 * 48 * 7 / 10);
}

// Nothing but the walls and some per cent of the picture with a hundred times as much.
TEST_CASE("the scale ends at twice what nine tenths of the picture stay below")
{
    const Scene scene = room_with_lamp();
    const Camera towards_lamp = {inside.eye, {1.7, 2.9, 1.7}, {0.0, 1.0, 0.0}, 25.0};
    const ScreenImage image = false_colour(scene, quantity(scene, 0.5, 50.0), towards_lamp, sized(64, 48));
    const long lamp = count_of(image, map_colour(1.0));
    REQUIRE(lamp > 64 * 48 / 100);
    REQUIRE(lamp < 64 * 48 / 10);
    CHECK(count_of(image, map_colour(0.5)) > 64 * 48 * 8 / 10); // twice 0.5 is the end
}

// A wall of eight columns, brighter by one from each to the next; the camera sees all of it, twenty pixels per column.
// The wall is whole, or ends one pixel beyond a contour, where slopes are known from one side only.
TEST_CASE("contours lie where the interpolated values reach the numbers of the legend, also at a border")
{
    for (const bool whole : {true, false}) {
        CAPTURE(whole);
        SceneBuilder builder;
        const std::uint32_t grey = builder.grey(0.5, 0.0);
        if (whole)
            builder.rectangle({0, 0, 0}, {8, 0, 0}, {0, 8, 0}, grey);
        else
            builder.rectangle({0, 0, 0}, {4.05, 0, 0}, {0, 8, 0}, grey)
                .rectangle({5, 0, 0}, {3, 0, 0}, {0, 8, 0}, grey);
        builder.rectangle({0, 0, 200}, {0, 1, 0}, {1, 0, 0}, builder.grey(0.0, 1.0)); // behind the camera
        const Scene scene = builder.scene(1.0);
        Quantity ramp{"ramp", {}};
        for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch) {
            const double value = scene.patch(patch).shape.centre().x;
            ramp.values.push_back({value, value, value});
        }
        const Camera facing = {{4, 4, 100}, {4, 4, 0}, {0, 1, 0}, 2.0 * std::atan(0.04) * 180.0 / 3.14159265358979};
        const RenderOptions size = sized(160, 160);
        const ScreenImage plain = false_colour(scene, ramp, facing, size);
        ramp.contours = true;
        ScreenImage lined = false_colour(scene, ramp, facing, size);
        const LegendScale scale = round_scale(7.5);
        REQUIRE(scale.top() == 8.0);
        REQUIRE(scale.steps == 4); // 2, 4, 6
        long columns = 0;
        for (int x = 0; x < 160; ++x) {
            const double value = (x + 0.5) / 20.0;
            const bool near = std::abs(std::remainder(value, 2.0)) <= 0.05 && value > 1.0 && value < 7.0;
            columns += near ? 1 : 0;
            for (int y = 0; y < 160; ++y) {
                CAPTURE(x);
                CAPTURE(y);
                const auto* before = &plain.bytes[3 * pixel_index(160, x, y)];
                CHECK(std::equal(before, before + 3, lined.at(x, y)) == !near);
            }
        }
        CHECK(columns == 6);
    }
}

// A wall that becomes brighter aside and, more so, upwards. With x of the scene up in the picture, what was a column is
// a row, from below.
TEST_CASE("contours turn with the camera")
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {8, 0, 0}, {0, 8, 0}, builder.grey(0.5, 0.0));
    builder.rectangle({0, 0, 200}, {0, 1, 0}, {1, 0, 0}, builder.grey(0.0, 1.0)); // behind the camera
    const Scene scene = builder.scene(1.0);
    Quantity ramp{"ramp", {}};
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch) {
        const Vec3 centre = scene.patch(patch).shape.centre();
        const double value = 0.3 * centre.x + 0.9 * centre.y;
        ramp.values.push_back({value, value, value});
    }
    constexpr int side = 96;
    const auto lined_pixels = [&](Vec3 up) {
        const Camera camera = {{4, 4, 100}, {4, 4, 0}, up, 2.0 * std::atan(0.04) * 180.0 / 3.14159265358979};
        ramp.contours = false;
        const ScreenImage plain = false_colour(scene, ramp, camera, sized(side, side));
        ramp.contours = true;
        ScreenImage lined = false_colour(scene, ramp, camera, sized(side, side));
        std::vector<char> result;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const auto* before = &plain.bytes[3 * pixel_index(side, x, y)];
                result.push_back(std::equal(before, before + 3, lined.at(x, y)) ? 0 : 1);
            }
        return result;
    };
    const std::vector<char> upright = lined_pixels({0, 1, 0});
    const std::vector<char> turned = lined_pixels({1, 0, 0});
    CHECK(std::count(upright.begin(), upright.end(), 1) > 3 * side);
    long different = 0; // by rounding, where a line just reaches a pixel
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            different += turned[pixel_index(side, x, y)] != upright[pixel_index(side, side - 1 - y, x)] ? 1 : 0;
    CHECK(different <= 4);
}

TEST_CASE("what only touches a level has no contour")
{
    const Scene scene = room_with_lamp();
    Quantity even = quantity(scene, 0.5, 0.5);
    const ScreenImage plain = false_colour(scene, even, inside, sized(64, 48));
    even.contours = true;
    CHECK(false_colour(scene, even, inside, sized(64, 48)).bytes == plain.bytes);
}

} // namespace false_colour_test

namespace quantity_test {

using namespace multipath;

// B = E + rho H, for an H that is made up. A rounding of B is a share of 1e-16 of E + rho H, so of H at most
// 1e-16 (1 + E / (rho H)) = 1e-16 (1 + 100 / 0.1) here.
TEST_CASE("the irradiance is the one that the radiosity comes from")
{
    SceneBuilder builder;
    builder.room({0, 0, 0}, {1, 1, 1}, builder.material({0.5, 0.2, 0.9}, {0, 0, 0}));
    builder.rectangle({0.2, 0.9, 0.2}, {0.5, 0, 0}, {0, 0, 0.5}, builder.material({0.1, 0.3, 0.8}, {100, 10, 1}));
    const Scene scene = builder.scene(0.3);
    std::vector<Rgb> expected;
    std::vector<Rgb> radiosity;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        expected.push_back({1.0 + i, 2.0 + 0.5 * i, 3.0 / (1.0 + i)});
        radiosity.push_back(scene.emittance(i) + scene.reflectance(i) * expected[i]);
    }
    const std::vector<Rgb> found = irradiance(scene, radiosity);
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        CHECK(found[i].r == doctest::Approx(expected[i].r).epsilon(1e-12));
        CHECK(found[i].g == doctest::Approx(expected[i].g).epsilon(1e-12));
        CHECK(found[i].b == doctest::Approx(expected[i].b).epsilon(1e-12));
    }
}

TEST_CASE("what reflects nothing does not tell its irradiance")
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, builder.material({0.0, 0.5, 0.0}, {2, 2, 2}));
    const Scene scene = builder.scene(1.0);
    const Rgb found = irradiance(scene, {{2.0, 3.0, 2.0}}).front();
    CHECK(std::isnan(found.r));
    CHECK(found.g == 2.0);
    CHECK(std::isnan(found.b));
}

TEST_CASE("an emittance rounded up is no light missing")
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, builder.grey(0.5, 2.0));
    const double below = std::nextafter(2.0, 0.0);
    CHECK(irradiance(builder.scene(1.0), {{below, below, below}}).front() == Rgb{});
}

// Alike: less than a step of 1/32 in every channel. One pair in fifty may be.
TEST_CASE("a screen can show the colours of the patches, and nearly all differ from the next")
{
    const std::vector<Rgb> colours = patch_colours(4000);
    int alike = 0;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        CHECK(std::min({colours[i].r, colours[i].g, colours[i].b}) >= 0.0);
        CHECK(std::max({colours[i].r, colours[i].g, colours[i].b}) <= 1.0);
        if (i == 0)
            continue;
        const Rgb d = colours[i] - colours[i - 1];
        alike += std::max({std::abs(d.r), std::abs(d.g), std::abs(d.b)}) < 1.0 / 32;
    }
    CHECK(alike < 4000 / 50);
}

TEST_CASE("the colours of normals are those of the axes, opposite ones complementary")
{
    SceneBuilder builder;
    builder.room({0, 0, 0}, {1, 1, 1}, builder.grey(0.5, 1.0));
    const std::vector<Rgb> colours = normal_colours(builder.scene(1.0)); // in the order of room()
    REQUIRE(colours.size() == 6);
    CHECK(colours[0] == srgb_decoded(Rgb{0.5, 1.0, 0.5})); // the floor looks along y
    CHECK(colours[1] == srgb_decoded(Rgb{0.5, 0.0, 0.5}));
    CHECK(colours[2] == srgb_decoded(Rgb{1.0, 0.5, 0.5}));
    CHECK(colours[5] == srgb_decoded(Rgb{0.5, 0.5, 0.0}));
}

TEST_CASE("magnitudes have no sign")
{
    CHECK(magnitudes({{-1.0, 2.0, -0.0}}) == std::vector<Rgb>{{1.0, 2.0, 0.0}});
}

} // namespace quantity_test
