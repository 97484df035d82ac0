#include "viewer/corner_values.h"

#include "image/corner_lattice.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

using namespace multipath;

namespace {

/// A rectangle, a triangle and a lamp far above.
SceneBuilder shapes()
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.5, 0.0);
    builder.rectangle({0, 0, 0}, {0, 0, 3}, {2, 0, 0}, wall);
    builder.triangle({10, 0, 0}, {10, 0, 2}, {12, 0, 0}, wall);
    return builder.rectangle({0, 50, 0}, {1, 0, 0}, {0, 0, 1}, builder.grey(0.5, 1.0));
}

} // namespace

TEST_CASE("there is a value for every corner of every patch, and it is that of the patches around it")
{
    for (const bool two_sided : {false, true}) {
        const Scene scene = shapes().scene(0.5, two_sided);
        std::vector<Rgb> heat; // rises with z, by which both shapes are cut alike
        for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch) {
            const double z = scene.patch(patch).shape.centre().z;
            heat.push_back({z, 1.0, 0.0});
        }
        const std::vector<Rgb> corners = corner_values(scene, heat);
        std::size_t n = 0;
        for (int side = 0; side < (two_sided ? 2 : 1); ++side)
            for (std::uint32_t s = 0; s < scene.surfaces().size(); ++s) {
                const CornerLattice lattice(scene.tessellation(s));
                for (std::uint32_t j = 0; j <= lattice.last_row(); ++j)
                    for (std::uint32_t i = 0; i <= lattice.last_column(j); ++i, ++n) {
                        REQUIRE(n < corners.size());
                        CHECK(corners[n].g == doctest::Approx(1.0));
                        // A ramp over a rectangle is kept.
                        if (s == 0)
                            CHECK(corners[n].r == doctest::Approx(3.0 * lattice.u(i)));
                        // Over a triangle it is kept inside; its borders are means of the patches there.
                        if (s == 1 && !lattice.on_border(i, j))
                            CHECK(corners[n].r == doctest::Approx(2.0 * lattice.u(i)));
                    }
            }
        CHECK(n == corners.size());
    }
}
