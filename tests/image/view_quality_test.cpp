#include "image/view_quality.h"

#include "test_scenes.h"

#include <cmath>
#include <doctest/doctest.h>

namespace view_quality_test {

using namespace multipath;

namespace {

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

} // namespace view_quality_test
