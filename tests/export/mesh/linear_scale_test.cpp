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

TEST_CASE("where everything shines, lamps count")
{
    SceneBuilder builder;
    const Scene scene = builder.rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, builder.grey(0.5, 1.0)).scene(1.0);
    CHECK(linear_scale(scene, {{1, 2, 1}}) == 0.5);
}

} // namespace linear_scale_test
