// Smooth shading of a floor on which something stands.

#include "shading_trials.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace shading_contact_test {

using namespace multipath;

namespace {

/// Floor of two rectangles that meet at x = 1, or of one; lit up to x = 1 and dark beyond.
SceneBuilder lit_and_dark_floor(bool one_surface)
{
    SceneBuilder builder = with_lamp();
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    builder.rectangle({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {one_surface ? 2.0 : 1.0, 0.0, 0.0}, paint);
    if (!one_surface)
        builder.rectangle({1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, paint);
    return builder;
}

std::vector<Rgb> lit_and_dark(const Scene& scene)
{
    return at_centres(scene, [](Vec3 p) { return p.x < 1.0 ? 8.0 : 0.0; });
}

/// The value on the floor at (x, 0, z).
double on_floor(const SmoothShading& shading, bool one_surface, double x, double z)
{
    if (one_surface)
        return shown(shading, 1, z, x / 2.0);
    return x < 1.0 ? shown(shading, 1, z, x) : shown(shading, 2, z, x - 1.0);
}

} // namespace

TEST_CASE("no light leaks below a wall that stands on the floor, be it a sheet or a box")
{
    for (const bool one_surface : {false, true})
        for (const double thickness : {0.0, 0.06}) {
            SceneBuilder builder = lit_and_dark_floor(one_surface);
            builder.box({1.0 - 0.5 * thickness, 0.0, 0.0}, {1.0 + 0.5 * thickness + 1e-9, 1.0, 1.0},
                        builder.grey(0.5, 0.0));
            const Scene scene = builder.scene(0.25);
            const std::vector<Rgb> values = lit_and_dark(scene);
            const SmoothShading shading(scene, values, 1);
            for (const double z : {0.0, 0.3, 1.0}) {
                CHECK(on_floor(shading, one_surface, 0.96, z) >= 8.0); // more on what the box leaves of the patch
                CHECK(on_floor(shading, one_surface, 1.04, z) == 0.0);
            }
        }
}

TEST_CASE("without the wall the floor is smooth, and the leg of a table does not part it")
{
    for (const bool one_surface : {false, true})
        for (const bool leg : {false, true}) {
            SceneBuilder builder = lit_and_dark_floor(one_surface);
            if (leg)
                builder.box({0.97, 0.0, 0.47}, {1.03, 0.7, 0.53}, builder.grey(0.5, 0.0));
            const Scene scene = builder.scene(0.25);
            const std::vector<Rgb> values = lit_and_dark(scene);
            const SmoothShading shading(scene, values, 1);
            for (const double z : {0.0, 0.3, 1.0})
                CHECK(on_floor(shading, one_surface, 1.0 - 1e-9, z) ==
                      doctest::Approx(on_floor(shading, one_surface, 1.0 + 1e-9, z)).epsilon(1e-6)); // of a steep ramp
        }
}

// A floor that is evenly lit where nothing stands on it: the patches below a box are black, those it covers in part are
// darker by that part.
TEST_CASE("what a box covers does not darken the floor around it")
{
    for (const double low : {0.5, 0.5625, 0.65625}) { // on the borders of patches, and across them
        SceneBuilder builder = with_lamp();
        builder.rectangle({0.0, 0.0, 0.0}, {0.0, 0.0, 2.0}, {2.0, 0.0, 0.0}, builder.grey(0.5, 0.0));
        builder.box({low, 0.0, low}, {1.25, 0.5, 1.25}, builder.grey(0.5, 0.0));
        const Scene scene = builder.scene(0.25);
        std::vector<Rgb> values(scene.patch_count(), grey(3.0));
        const auto covered = [&](double from) {
            return std::max(0.0, std::min(from + 0.25, 1.25) - std::max(from, low));
        };
        for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch)
            if (scene.surface_of(patch) == 1) {
                const Vec3 corner = scene.patch(patch).shape.origin;
                values[patch] = grey(3.0 * (1.0 - covered(corner.x) * covered(corner.z) / (0.25 * 0.25)));
            }
        const SmoothShading shading(scene, values, 1);
        for (double u = 0.012; u < 1.0; u += 0.03)
            for (double v = 0.012; v < 1.0; v += 0.03) {
                const bool below_box = std::min(u, v) > 0.5 * low && std::max(u, v) < 0.625;
                if (!below_box)
                    CHECK(shown(shading, 1, u, v) == doctest::Approx(3.0)); // borders of the box lie between samples
            }
    }
}

} // namespace shading_contact_test
