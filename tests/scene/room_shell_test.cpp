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
    const std::size_t count = turn_shell_inward(file);
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

TEST_CASE("an open room is left as it is")
{
    SceneFile open = furnished(true, 3.0);
    open.surfaces[0] = open.surfaces[6];
    std::vector<bool> which;
    CHECK(turn(open, which) == 0);
}

} // namespace room_shell_test
