#include "export/mesh/linear_scale.h"

#include "test_scenes.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

namespace linear_scale_test {

using namespace multipath;

TEST_CASE("white is what is brightest beside lamps and the hundredth part next to them")
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {30, 0, 0}, {0, 5, 0}, builder.grey(0.5, 0.0));
    const Scene scene = builder.rectangle({0, 0, 9}, {1, 0, 0}, {0, 1, 0}, builder.grey(0.5, 100.0)).scene(1.0);
    std::vector<Rgb> values(scene.patch_count(), Rgb{1, 2, 4});
    values[7] = {5, 50, 0}; // 1 of 150: a spot
    values[150] = {100, 100, 100};
    CHECK(linear_scale(scene, values) == 0.25);
    values[8] = {8, 0, 0}; // 2 of 150 are no spot
    CHECK(linear_scale(scene, values) == 0.125);
    for (std::uint32_t patch = 8; patch < 30; ++patch)
        values[patch] = {0, 0, 400}; // a seventh, a hundred times as bright as the rest
    CHECK(linear_scale(scene, values) == 0.18 / 4.0);
    CHECK(linear_scale(scene, std::vector<Rgb>(scene.patch_count())) == 1.0);
}

// Of the cells a third is dark, and these are cut most finely, or the others.
TEST_CASE("white does not depend on how finely the dark or the bright is cut")
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {9, 0, 1}, {0, 7, 0}, builder.grey(0.5, 0.0));
    const Scene whole = builder.rectangle({0, 0, 9}, {1, 0, 0}, {0, 1, 0}, builder.grey(0.5, 100.0)).scene(1.5);
    const Scene cut = unevenly_refined(whole);
    for (const std::uint32_t dark : {0u, 1u, 2u}) {
        CAPTURE(dark);
        const auto values_of = [&](const Scene& scene) {
            std::vector<Rgb> values;
            for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch) {
                const Vec3 p = scene.patch(patch).shape.centre();
                const std::uint32_t cell = whole.patch_at(scene.surface_of(patch), p.x / 9.0, p.y / 7.0, true);
                values.push_back(cell % 3 == dark ? Rgb{0.2, 0.1, 0.1} : Rgb{1.0, 2.0, 3.0 + 0.01 * cell});
            }
            return values;
        };
        CHECK(linear_scale(cut, values_of(cut)) == linear_scale(whole, values_of(whole)));
    }
}

TEST_CASE("where everything shines, lamps count")
{
    SceneBuilder builder;
    const Scene scene = builder.rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, builder.grey(0.5, 1.0)).scene(1.0);
    CHECK(linear_scale(scene, {{1, 2, 1}}) == 0.5);
}

} // namespace linear_scale_test
