#include "image/gather/light_grid.h"

#include "base/errors.h"
#include "test_scenes.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <sstream>
#include <string>

namespace light_grid_test {

using namespace multipath;

namespace {

/// A closed room of 3 x 2 x 4 m whose walls all have E = 1 W/m^2 and reflectance 1/2, so that B = H + E = 2 W/m^2 and
/// the irradiance of any point in it, facing anywhere, is 2 W/m^2 as well. `turned` maps its coordinates, of which y is
/// the height, to those of the scene.
template <class Turn>
Scene bright_room(const Turn& turned, SceneBuilder builder = {})
{
    SceneFile file = builder.room({0, 0, 0}, {3, 2, 4}, builder.grey(0.5, 1.0)).file();
    for (Surface& s : file.surfaces) {
        const Vec3 zero = turned(Vec3{});
        s = {s.shape, turned(s.origin), turned(s.edge_u) - zero, turned(s.edge_v) - zero};
    }
    return Scene(file, 10.0);
}

const std::vector<Vec3> shifts = {{0, 0, 0}, {3, -7, 2.5}, {500000, 120, 4649776}};

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

// The height counts from the floor, wherever that lies and whatever is upwards.
TEST_CASE("a grid of height 0 lies on the floor and has its light")
{
    for (const Vec3 shift : shifts)
        for (const int axis : {0, 1, 2}) {
            const Vec3 up = {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
            const Scene scene = bright_room([&](Vec3 p) { // axes exchanged in a ring: still a rotation
                return shift + (axis == 0 ? Vec3{p.y, p.z, p.x} : axis == 1 ? p : Vec3{p.z, p.x, p.y});
            });
            const std::vector<Rgb> radiosity(scene.patch_count(), Rgb{2, 2, 2});
            for (const double height : {0.0, 0.75}) {
                CAPTURE(height);
                const LightGrid grid = light_grid(scene, radiosity, {height, 0.5, 2.0 * up}, 1024, 1);
                CHECK(grid.points.size() == 6 * 8);
                for (const GridPointLight& point : grid.points) {
                    CHECK(std::abs(dot(point.point - shift, up) - height) < 1e-8); // rounding millions of metres away
                    // 1024 quasi-random rays to emitters and as many in all directions: well below a percent.
                    CHECK(mean(point.irradiance) == doctest::Approx(2.0).epsilon(0.01));
                }
            }
            CHECK_THROWS_AS(light_grid(scene, radiosity, {-0.1, 0.5, up}, 16, 1), SettingsError);
            CHECK_THROWS_AS(light_grid(scene, radiosity, {2.0, 0.5, up}, 16, 1), SettingsError);
        }
}

TEST_CASE("a point of a grid on a table has the light of the table, one in it is left out")
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 1.0);
    builder.box({1, 0.5, 1}, {2, 1, 3}, paint); // a slab, 0.5 m above the floor
    const Scene scene = bright_room([](Vec3 p) { return p; }, builder);
    const std::vector<Rgb> radiosity(scene.patch_count(), Rgb{2, 2, 2});
    const auto points_at = [&](double height) {
        const LightGrid grid = light_grid(scene, radiosity, {height, 0.5, {0, 1, 0}}, 256, 1);
        for (const GridPointLight& point : grid.points)
            CHECK(mean(point.irradiance) == doctest::Approx(2.0).epsilon(0.02)); // as above, with a quarter of the rays
        return grid.points.size();
    };
    CHECK(points_at(1.0) == 48);
    CHECK(points_at(0.75) == 48 - 8);
    CHECK(points_at(0.25) == 48);
}

// Below a sheet that faces up there is room; what stands on the floor needs no bottom to be solid.
TEST_CASE("no point of a grid lies in a block without a bottom, but some lie below a sheet")
{
    for (const bool sides : {false, true})
        for (const double height : {0.0, 0.25, 0.75}) {
            SceneBuilder builder;
            const std::uint32_t paint = builder.grey(0.5, 0.0);
            builder.rectangle({1, 0.5, 1}, {0, 0, 2}, {1, 0, 0}, paint); // the top
            if (sides) {
                builder.rectangle({1, 0, 1}, {0, 0, 2}, {0, 0.5, 0}, paint);
                builder.rectangle({2, 0, 1}, {0, 0.5, 0}, {0, 0, 2}, paint);
                builder.rectangle({1, 0, 1}, {0, 0.5, 0}, {1, 0, 0}, paint);
                builder.rectangle({1, 0, 3}, {1, 0, 0}, {0, 0.5, 0}, paint);
            }
            const Scene scene = bright_room([](Vec3 p) { return p; }, builder);
            const std::vector<Rgb> radiosity(scene.patch_count());
            const LightGrid grid = light_grid(scene, radiosity, {height, 0.5, {0, 1, 0}}, 16, 1);
            CHECK(grid.points.size() == (sides && height < 0.5 ? 48 - 8 : 48));
        }
}

TEST_CASE("the table of a grid is exact to a millionth of the scene's size, wherever that lies")
{
    for (const Vec3 shift : shifts) {
        const Scene scene = bright_room([&](Vec3 p) { return shift + p; });
        const LightGrid grid = light_grid(scene, std::vector<Rgb>(scene.patch_count()), {0.7, 1.3, {0, 1, 0}}, 16, 1);
        std::istringstream lines(light_grid_table(scene, grid));
        std::string line;
        REQUIRE(std::getline(lines, line));
        for (const GridPointLight& point : grid.points) {
            REQUIRE(std::getline(lines, line));
            std::replace(line.begin(), line.end(), ',', ' ');
            std::istringstream numbers(line);
            Vec3 p;
            numbers >> p.x >> p.y >> p.z;
            CHECK(length(p - point.point) < 1e-6 * scene.own_bounds().diagonal());
        }
        CHECK(!std::getline(lines, line));
    }
}

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
