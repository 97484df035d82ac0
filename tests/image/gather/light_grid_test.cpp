#include "image/gather/light_grid.h"

#include "radiosity/solve.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

namespace light_grid_test {

using namespace multipath;

namespace {

/// A room with a lamp and a table, moved by an offset.
Scene room_at(Vec3 offset)
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    builder.room({0, 0, 0}, {4, 3, 5}, paint).box({1, 0, 2}, {2, 0.75, 3}, paint);
    builder.rectangle({1.5, 2.875, 2}, {1, 0, 0}, {0, 0, 1}, builder.grey(0.5, 10.0));
    SceneFile file = builder.file();
    for (Surface& surface : file.surfaces)
        surface.origin = surface.origin + offset;
    return Scene(file, 0.5);
}

LightGrid grid_at(Vec3 offset, Vec3 up)
{
    const Scene scene = room_at(offset);
    std::vector<Rgb> radiosity;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        radiosity.push_back(scene.emittance(i) + Rgb{1.0 + i % 7, 1.0 + i % 5, 1.0 + i % 3});
    return light_grid(scene, radiosity, {0.5, 0.5, up}, 64, 1);
}

} // namespace

// Coordinates and offsets are multiples of powers of two, so that few of them are rounded.
TEST_CASE("a grid moves with its scene, along any axis")
{
    for (const Vec3 up : {Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{-1, 0, 0}}) {
        const LightGrid here = grid_at({0, 0, 0}, up);
        REQUIRE(here.points.size() > 10);
        for (const Vec3 offset : {Vec3{32, -16, 8}, Vec3{-64, 128, -256}}) {
            const LightGrid there = grid_at(offset, up);
            REQUIRE(there.points.size() == here.points.size());
            for (std::size_t k = 0; k < here.points.size(); ++k) {
                CHECK(length(there.points[k].point - here.points[k].point - offset) < 1e-9);
                // Shadow rays and weights are rounded: 1e-13 of the offset.
                CHECK(mean(there.points[k].irradiance) ==
                      doctest::Approx(mean(here.points[k].irradiance)).epsilon(1e-9));
            }
            CHECK(there.least == doctest::Approx(here.least).epsilon(1e-9));
        }
    }
}

} // namespace light_grid_test
