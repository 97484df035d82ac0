#include "image/clear_sight.h"

#include "sampling/sequence.h"
#include "scene/obj_reader.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace clear_sight_test {

using namespace multipath;

namespace {

/// A floor of 2 x 2 patches of 1 m, and 1 m above the one at the origin a lamp of 1 m^2 that looks down.
SceneBuilder lit_floor()
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {0, 0, 2}, {2, 0, 0}, builder.grey(0.5, 0.0));
    return builder.rectangle({0, 1, 0}, {1, 0, 0}, {0, 0, 1}, builder.grey(0.0, 1.0));
}

/// Is the lamp in clear sight of the patch under the point (x, 0, z)?
bool is_clear(const Scene& scene, double x, double z)
{
    return ClearSight(scene, {1}).is_clear(scene.patch_at(0, z / 2, x / 2, true), 0);
}

} // namespace

TEST_CASE("a patch and a lamp see each other clearly if nothing reaches between them")
{
    CHECK(is_clear(lit_floor().scene(1.0), 0.5, 0.5));
    CHECK(is_clear(lit_floor().scene(1.0), 1.5, 1.5));

    SceneBuilder walled = lit_floor(); // walls at the edge of the floor, of the lamp, and a ceiling that holds the lamp
    walled.rectangle({0, 0, 0}, {0, 3, 0}, {2, 0, 0}, walled.grey(0.5, 0.0));
    walled.rectangle({-4, 1, -4}, {8, 0, 0}, {0, 0, 8}, walled.grey(0.5, 0.0));
    CHECK(is_clear(walled.scene(1.0), 0.5, 0.5));

    SceneBuilder board = lit_floor(); // a small one half way up
    board.rectangle({0.4, 0.5, 0.4}, {0.01, 0, 0}, {0, 0, 0.01}, board.grey(0.5, 0.0));
    CHECK_FALSE(is_clear(board.scene(1.0), 0.5, 0.5));
    CHECK(is_clear(board.scene(1.0), 1.5, 1.5));

    SceneBuilder sheet = lit_floor(); // flat on one of the patches
    sheet.rectangle({1.2, 0, 1.2}, {0.5, 0, 0}, {0, 0, 0.5}, sheet.grey(0.5, 0.0));
    CHECK_FALSE(is_clear(sheet.scene(1.0), 1.5, 1.5));
    CHECK(is_clear(sheet.scene(1.0), 0.5, 0.5));

    CHECK_FALSE(ClearSight(lit_floor().scene(1.0), {1}).is_clear(Scene::no_patch, 0));
}

TEST_CASE("no ray between a patch and a lamp in clear sight of it meets anything else")
{
    for (const char* file : {"scenes/4chairs.obj", "scenes/5cubes.obj"}) {
        const Scene scene(read_obj(file), 0.25);
        std::uint32_t lamp = 0;
        while (scene.emittance(scene.first_patch(lamp)) == Rgb{})
            ++lamp;
        const ClearSight sight(scene, {lamp});
        const Surface& source = scene.surfaces()[lamp];
        std::vector<Item> items(50);
        int clear = 0;
        int hidden = 0;
        for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch) {
            const Surface shape = scene.patch(patch).shape;
            REQUIRE(shape.shape == Shape::parallelogram);
            if (!sight.is_clear(patch, 0))
                continue;
            ++clear;
            make_sequence("random", patch)->generate(0, items);
            for (const Item& item : items) {
                const Vec3 from = shape.at(item[0], item[1]);
                const Vec3 way = source.at(item[2], item[3]) - from;
                if (dot(way, shape.normal()) <= 0.0 || dot(way, source.normal()) >= 0.0)
                    continue; // behind a horizon
                const std::uint32_t own = scene.surface_of(patch);
                const std::optional<Hit> hit = scene.intersector().closest_hit_from(own, {from, normalized(way)});
                hidden += !hit || hit->surface != lamp ? 1 : 0;
            }
        }
        CHECK(clear > static_cast<int>(scene.patch_count()) / 5);
        CHECK(hidden == 0);
    }
}

} // namespace clear_sight_test
