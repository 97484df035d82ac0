#include "scene/room_shell.h"

#include "scene/scene_builder.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

namespace room_shell_test {

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

std::vector<bool> turned(const SceneFile& before, const SceneFile& after)
{
    std::vector<bool> result;
    for (std::size_t s = 0; s < before.surfaces.size(); ++s)
        result.push_back(dot(before.surfaces[s].normal(), after.surfaces[s].normal()) < 0.0);
    return result;
}

std::size_t turn(SceneFile file, std::vector<bool>& which)
{
    const SceneFile before = file;
    const std::size_t count = turn_shells_inward(file);
    which = turned(before, file);
    return count;
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

} // namespace room_shell_test
