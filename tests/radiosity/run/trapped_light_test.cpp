#include "radiosity/run/trapped_light.h"

#include "base/errors.h"
#include "radiosity/run/solve.h"
#include "scene/scene_builder.h"

#include <doctest/doctest.h>
#include <functional>

namespace trapped_light_test {

using namespace multipath;

namespace {

const Rgb white = {1, 1, 1};
const Rgb grey = {0.5, 0.5, 0.5};

/// A closed room with a lamp, and in it a closed box whose inside has the colour `inside` and a lamp of `light`.
SceneBuilder room_with_cell(Rgb inside, Rgb light)
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.material("wall", grey, {});
    const std::uint32_t lamp = builder.material("lamp", grey, white);
    const std::uint32_t inner = builder.material("inner", inside, {});
    const std::uint32_t inner_lamp = builder.material("inner lamp", inside, light);
    builder.room({0, 0, 0}, {4, 4, 4}, {wall, lamp, wall, wall, wall, wall});
    builder.box({1, 1, 1}, {2, 2, 2}, wall);
    builder.room({1.1, 1.1, 1.1}, {1.9, 1.9, 1.9}, {inner, inner_lamp, inner, inner, inner, inner});
    return builder;
}

SolveOptions options_of(Method method, std::uint64_t lines, double memory)
{
    SolveOptions options;
    options.method = method;
    options.lines = lines;
    options.memory = memory;
    return options;
}

} // namespace

TEST_CASE("light in a closed white box is trapped, in whatever channel, and in a dark one it is not")
{
    CHECK(patch_of_trapped_light(room_with_cell(white, white).scene(0.2)).has_value());
    CHECK(patch_of_trapped_light(room_with_cell({0.2, 1, 0.2}, white).scene(0.2)).has_value());
    CHECK(patch_of_trapped_light(room_with_cell(white, {0, 1e-20, 0}).scene(0.2)).has_value());
    CHECK(!patch_of_trapped_light(room_with_cell({0.2, 1, 0.2}, {1, 0, 1}).scene(0.2)).has_value());
    CHECK(!patch_of_trapped_light(room_with_cell({0.999, 0.999, 0.999}, white).scene(0.2)).has_value());
    CHECK(!patch_of_trapped_light(room_with_cell(white, {}).scene(0.2)).has_value()); // no light in it
}

TEST_CASE("a white box with one small face that absorbs traps no light")
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.material("white", white, {});
    const std::uint32_t lamp = builder.material("lamp", white, white);
    const std::uint32_t dark = builder.material("dark", {0.9, 0.9, 0.9}, {});
    builder.room({0, 0, 0}, {4, 4, 4}, {wall, lamp, wall, wall, wall, wall});
    CHECK(patch_of_trapped_light(builder.scene(0.2)).has_value());
    builder.rectangle({1, 0.01, 1}, {0, 0, 0.4}, {0.4, 0, 0}, dark); // a six-hundredth of the area, looks up
    CHECK(!patch_of_trapped_light(builder.scene(0.2)).has_value());
}

TEST_CASE("every method refuses a scene in which light is trapped")
{
    const Scene scene = room_with_cell(white, white).scene(0.2);
    for (const Method method : all_methods())
        for (const double memory : {1e6, 1e9})
            CHECK_THROWS_AS(solve(scene, options_of(method, 20000, memory), [](double) {}), InputError);
}

// With b the mean over the cell of area A, the light of its lamp is absorbed: (1 - rho) (b - E_mean) / rho A = E_mean
// A. A leak of 1e-4 out of the cell would halve it.
TEST_CASE("a cell that reflects all but 1e-4 keeps its light, with a table of pairs and without, and by particles")
{
    constexpr double rho = 0.9999;
    const Scene scene = room_with_cell({rho, rho, rho}, white).scene(0.1);
    for (const SolveOptions& options :
         {options_of(Method::reuse, 1u << 20, 1e9), options_of(Method::reuse, 1u << 20, 2e7),
          options_of(Method::local, 1u << 20, 1e9)}) {
        CAPTURE(options.memory);
        const Solution solution = solve(scene, options, [](double) {});
        double power = 0.0;
        double area = 0.0;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            if (scene.reflectance(i).g == rho) {
                power += scene.area(i) * solution.radiosity[i].g;
                area += scene.area(i);
            }
        REQUIRE(area == doctest::Approx(6 * 0.64));
        const double emitted = 1.0 / 6.0; // W/m^2, mean over the cell
        // Particles: 100 of them for the cell, each with a path of 1e4 (1 +- 1) reflections.
        const double tolerance = options.method == Method::local ? 0.4 : 0.005;
        CHECK(power / area == doctest::Approx(emitted + rho * emitted / (1.0 - rho)).epsilon(tolerance));
    }
}

} // namespace trapped_light_test
