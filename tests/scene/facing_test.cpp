#include "scene/facing.h"

#include "base/elementary.h"
#include "scene/daylight.h"
#include "scene/scene_builder.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace facing_test {

using namespace multipath;

namespace {

/// [0, 4]^3 with a lamp, a sheet, and a block in it.
SceneFile furnished(bool outward, double lamp_height)
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.5, 0.0);
    const std::uint32_t lamp = builder.grey(0.0, 1.0);
    outward ? builder.box({0, 0, 0}, {4, 4, 4}, wall) : builder.room({0, 0, 0}, {4, 4, 4}, wall);
    builder.box({1, 0.5, 1}, {2, 1.5, 2}, wall);
    builder.rectangle({1, lamp_height, 1}, {1, 0, 0}, {0, 0, 1}, lamp);
    return builder.file();
}

std::size_t turn(const SceneFile& file, std::vector<bool>& which, bool two_sided = false)
{
    const std::vector<std::uint32_t> turned = surfaces_to_turn(file, Intersector(file.surfaces), two_sided);
    which.assign(file.surfaces.size(), false);
    for (const std::uint32_t s : turned)
        which[s] = true;
    return turned.size();
}

} // namespace

TEST_CASE("walls that look away from a lamp in the room are turned, what stands in the room is not")
{
    std::vector<bool> which;
    CHECK(turn(furnished(true, 3.0), which) == 6);
    CHECK(which ==
          std::vector<bool>{true, true, true, true, true, true, false, false, false, false, false, false, false});
    CHECK(turn(furnished(false, 3.0), which) == 0);
    CHECK(turn(furnished(true, 5.0), which) == 0); // the lamp lights the box from outside
}

TEST_CASE("a convex room with its lamp in its walls is turned, a thing that glows is not")
{
    std::vector<bool> which;
    /// Flat, or with a second step on it, whose ceiling glows, or all.
    const auto box = [](bool outward, bool all_glow, bool stepped) {
        SceneBuilder builder;
        const std::uint32_t wall = builder.grey(0.5, all_glow ? 1.0 : 0.0);
        const std::uint32_t lamp = builder.grey(0.5, 1.0);
        builder.room({0, 0, 0}, {4, 2, 2}, {wall, stepped ? wall : lamp, wall, wall, wall, wall});
        if (stepped)
            builder.room({0, 2, 0}, {2, 4, 2}, {wall, lamp, wall, wall, wall, wall});
        return outward ? flipped(builder.file()) : builder.file();
    };
    CHECK(turn(box(true, false, false), which) == 6);
    CHECK(turn(box(false, false, false), which) == 0);
    CHECK(turn(box(true, true, false), which) == 0);
    CHECK(turn(box(true, false, true), which) == 0); // its lamp may light the lower step
}

TEST_CASE("a room's walls belong together whatever rounding does, and without what touches them")
{
    std::vector<bool> which;
    const auto room = [](Vec3 low, Vec3 high, double lamp_height) {
        SceneBuilder builder;
        const std::uint32_t wall = builder.grey(0.5, 0.0);
        const Vec3 d = high - low;
        builder.box(low, high, wall);
        builder.box(low, low + Vec3{0.3 * d.x, d.y, 0.3 * d.z}, wall); // a pillar in the corner
        builder.rectangle(low + Vec3{0.5 * d.x, lamp_height * d.y, 0.5 * d.z}, {0.2 * d.x, 0, 0}, {0, 0, 0.2 * d.z},
                          builder.grey(0.0, 1.0));
        return builder.file();
    };
    const std::vector<bool> walls = {true,  true,  true,  true,  true,  true, false,
                                     false, false, false, false, false, false};
    for (const double lamp_height : {0.7, 1.0}) { // below the ceiling, and in it
        CHECK(turn(room({0, 0, 0}, {4, 4, 4}, lamp_height), which) == 6);
        CHECK(which == walls);
        CHECK(turn(room({-2.920992, 2.024814, -1.443876}, {-0.217999, 7.011749, 1.966915}, lamp_height), which) == 6);
        CHECK(which == walls);
        CHECK(turn(room({1e6 + 0.1, 0.3, 0}, {1e6 + 4.7, 2.9, 5.3}, lamp_height), which) == 6);
        CHECK(which == walls);
    }
}

TEST_CASE("of two houses on a plain each is turned that surrounds its lamp; the housing of a lamp is not")
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.5, 0.0);
    const std::uint32_t lamp = builder.grey(0.0, 1.0);
    builder.rectangle({-20, 0, -20}, {0, 0, 40}, {40, 0, 0}, wall);
    builder.box({0, 0.5, 0}, {4, 4, 4}, wall);
    builder.rectangle({1, 3, 1}, {1, 0, 0}, {0, 0, 1}, lamp);
    builder.room({6, 0.5, 0}, {10, 4, 4}, wall);
    builder.rectangle({7, 3, 1}, {1, 0, 0}, {0, 0, 1}, lamp);
    builder.box({12, 2, 0}, {13, 2.1, 1}, wall);
    for (int strip = 0; strip < 40; ++strip) // more than are looked at
        builder.rectangle({12.02 + 0.024 * strip, 2.05, 0.02}, {0.024, 0, 0}, {0, 0, 0.96}, lamp);
    std::vector<bool> which;
    CHECK(turn(builder.file(), which) == 6);
    for (std::size_t s = 0; s < which.size(); ++s)
        CHECK(which[s] == (s >= 1 && s <= 6));
}

TEST_CASE("an open room is left as it is")
{
    SceneFile open = furnished(true, 3.0);
    open.surfaces[0] = open.surfaces[6];
    std::vector<bool> which;
    CHECK(turn(open, which) == 0);
}

namespace {

enum class Source { none, sky, sun, both };

/// Closed shells, with lamps among them. A shell is modelled as its light needs it: outwards or inwards.
struct Shells
{
    std::string name;
    struct Shell
    {
        Vec3 low, high;
        bool outward;
    };
    std::vector<Shell> shells;
    std::vector<Vec3> lamps; ///< squares of 0.5 x 0.5 that shine down
    Source source = Source::none;
    std::uint64_t lit; ///< bit k: light reaches the front of shell k, and its front only

    /// Moved by `offset`, then scaled; bit k of `reversed` turns shell k inside out.
    SceneFile file(double scale, Vec3 offset, bool triangles, std::uint64_t reversed) const
    {
        SceneBuilder builder;
        const std::uint32_t wall = builder.grey(0.5, 0.0);
        const auto place = [&](Vec3 p) { return scale * (p + offset); };
        for (std::size_t k = 0; k < shells.size(); ++k) {
            const Vec3 low = place(shells[k].low), high = place(shells[k].high);
            shells[k].outward != ((reversed >> k & 1) != 0) ? builder.box(low, high, wall)
                                                            : builder.room(low, high, wall);
        }
        SceneFile file = builder.file();
        if (triangles) {
            SceneBuilder cut;
            cut.grey(0.5, 0.0);
            for (const Surface& s : file.surfaces)
                cut.triangle(s.at(0, 0), s.at(1, 0), s.at(1, 1), wall)
                    .triangle(s.at(0, 0), s.at(1, 1), s.at(0, 1), wall);
            builder = cut;
        }
        const std::uint32_t lamp = builder.grey(0.0, 1.0);
        for (const Vec3 corner : lamps)
            builder.rectangle(place(corner), {0.5 * scale, 0, 0}, {0, 0, 0.5 * scale}, lamp);
        file = builder.file();
        if (source == Source::sun || source == Source::both)
            file.sun = sun_at(130.0, 50.0, {0, 1, 0}, {1.0, 1.0, 1.0});
        if (source == Source::sky || source == Source::both)
            add_sky(file, {1.0, 1.0, 1.0});
        return file;
    }
};

std::vector<Shells> nested_shells()
{
    const Shells::Shell inside{{0, 0, 0}, {4, 3, 4}, false}, outside{{-0.3, -0.3, -0.3}, {4.3, 3.3, 4.3}, true};
    const Shells::Shell second_inside{{10, 0, 0}, {14, 3, 4}, false}, second{{9.7, -0.3, -0.3}, {14.3, 3.3, 4.3}, true};
    const Shells::Shell hall{{-10, -10, -10}, {20, 10, 20}, false}, building{{-11, -11, -11}, {21, 11, 21}, true};
    const Vec3 in{1.5, 2.9, 1.5}, in_second{11.5, 2.9, 1.5}, above{1.5, 8, 1.5}, below{1.5, -5, 1.5};
    return {{"a room", {inside}, {in}, Source::none, 1},
            {"a solid below a lamp", {outside}, {above}, Source::none, 1},
            {"a house, lit in it", {inside, outside}, {in}, Source::none, 1},
            {"a house, lit from outside", {inside, outside}, {above}, Source::none, 2},
            {"a house, lit by both", {inside, outside}, {in, above}, Source::none, 3},
            {"a house under the sky", {inside, outside}, {in}, Source::sky, 3},
            {"a house in the sun", {inside, outside}, {in}, Source::sun, 3},
            {"two houses", {inside, outside, second_inside, second}, {in, in_second}, Source::sky, 15},
            {"two houses, one dark", {inside, outside, second_inside, second}, {in}, Source::sun, 11},
            {"a house in a hall", {inside, outside, hall}, {in, above}, Source::none, 7},
            {"a house above the lamp of a hall", {inside, outside, hall}, {in, below}, Source::none, 7},
            {"a house in a building", {inside, outside, hall, building}, {in, above}, Source::sky, 15},
            {"a solid and a lamp in a hall", {outside, hall}, {above}, Source::none, 3},
            {"a box in the shade of a roof",
             {{{-0.5, 0, -0.5}, {0.5, 1, 0.5}, true}, {{-9, 5, -9}, {9, 6, 9}, true}},
             {},
             Source::both,
             3},
            {"a box below a table, lit by the walls alone",
             {inside, {{0.5, 1, 0.5}, {3.5, 1.2, 3.5}, true}, {{1.8, 0.2, 1.7}, {2.2, 0.6, 2.3}, true}},
             {in},
             Source::none,
             7},
            // Whichever way these look, their fronts are lit.
            {"a wall of one sheet between two lamps", {outside}, {in, above}, Source::none, 0},
            {"a room of one sheet under the sky", {inside}, {in}, Source::sky, 0},
            {"a room of one sheet in the sun", {inside}, {in}, Source::sun, 0}};
}

} // namespace

TEST_CASE("of nested shells exactly those are turned that light meets from behind, however they are modelled")
{
    struct Model
    {
        double scale;
        Vec3 offset;
        bool triangles;
    };
    for (const Model& model : {Model{1.0, {}, false}, Model{1.0, {}, true}, Model{1e-4, {}, false},
                               Model{1.0, {5e5, 30.0, 4.6e6}, false}, Model{1e3, {-1e4, 0.1, 0.7}, true}})
        for (const Shells& scene : nested_shells())
            for (std::uint64_t reversed = 0; reversed < 1ull << scene.shells.size(); ++reversed) {
                if (scene.shells.size() > 2 && reversed % 5 != 0) // all, none, and single ones among others
                    continue;
                CAPTURE(scene.name);
                CAPTURE(model.scale);
                CAPTURE(model.triangles);
                CAPTURE(reversed);
                std::vector<bool> which;
                turn(scene.file(model.scale, model.offset, model.triangles, reversed), which);
                const std::size_t faces = model.triangles ? 12 : 6;
                std::vector<bool> expected(which.size(), false);
                for (std::size_t s = 0; s < faces * scene.shells.size(); ++s)
                    expected[s] = (reversed & scene.lit) >> (s / faces) & 1;
                CHECK(which == expected);
            }
}

TEST_CASE("open meshes are turned that light meets only from behind, if no other front is lit")
{
    /// A sheet, a tent of two triangles, a box without a lid and a bowl of triangles, which face upwards; one below
    /// a lamp, two in the sun.
    const auto meshes = [](SceneBuilder& builder, int kind, bool reversed, bool sun, std::uint32_t wall) {
        for (const double x : {0.0, 20.0}) {
            if (x > 0.0 && !sun)
                break;
            const Vec3 o = {x, 0, 0};
            SceneBuilder mesh;
            if (kind == 0)
                mesh.rectangle(o, {0, 0, 2}, {2, 0, 0}, wall);
            if (kind == 1)
                mesh.triangle(o, o + Vec3{0, 0, 2}, o + Vec3{1, -1, 1}, wall)
                    .triangle(o, o + Vec3{1, -1, 1}, o + Vec3{2, 0, 0}, wall);
            if (kind == 2)
                mesh.room(o, o + Vec3{2, 1, 2}, wall);
            const int sides = 12;
            for (int k = 0; kind == 3 && k < sides; ++k) {
                const auto rim = [&](int at) {
                    return o + Vec3{1 + std::sin(2 * pi * at / sides), 0.5, 1 + std::cos(2 * pi * at / sides)};
                };
                mesh.triangle(o + Vec3{1, 0, 1}, rim(k), rim(k + 1), wall);
            }
            const SceneFile file = reversed ? flipped(mesh.file()) : mesh.file();
            for (std::size_t s = 0; s < file.surfaces.size(); ++s)
                if (kind != 2 || s != 1) // the lid
                    builder.surface(file.surfaces[s], wall);
        }
    };
    for (int kind = 0; kind < 4; ++kind)
        for (const bool reversed : {false, true})
            for (const bool sun : {false, true}) {
                CAPTURE(kind);
                CAPTURE(reversed);
                CAPTURE(sun);
                SceneBuilder builder;
                const std::uint32_t wall = builder.grey(0.5, 0.0);
                meshes(builder, kind, reversed, sun, wall);
                const std::size_t count = builder.file().surfaces.size();
                if (sun)
                    builder.sun(sun_at(0.0, 90.0, {0, 1, 0}, {1, 1, 1}));
                else
                    builder.rectangle({0.5, 4, 0.5}, {0.5, 0, 0}, {0, 0, 0.5}, builder.grey(0.0, 1.0)); // shines down
                std::vector<bool> which;
                CHECK(turn(builder.file(), which) == (reversed ? count : 0));
                CHECK(std::count(which.begin(), which.begin() + static_cast<std::ptrdiff_t>(count), reversed) ==
                      static_cast<std::ptrdiff_t>(count));
                CHECK(turn(builder.file(), which, true) == 0);
                builder.rectangle({40, 0, 0}, {0, 0, 2}, {2, 0, 0}, wall); // lit in front
                if (sun)
                    CHECK(turn(builder.file(), which) == 0);
            }
}

TEST_CASE("the housing of the only lamp in a room is not opened by turning the room")
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.5, 0.0);
    builder.room({0, 0, 0}, {4, 4, 4}, wall);
    builder.box({1, 3, 1}, {2, 3.1, 2}, wall);
    builder.rectangle({1.05, 3.05, 1.05}, {0.9, 0, 0}, {0, 0, 0.9}, builder.grey(0.0, 1.0));
    std::vector<bool> which;
    CHECK(turn(builder.file(), which) == 0);
}

} // namespace facing_test
