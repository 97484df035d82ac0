#include "image/shading/visible_patches.h"

#include "test_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace visible_patches_test {

using namespace multipath;

namespace {

/// Length of the part of [low, high] outside of [from, to], as a share.
double share_inside(double low, double high, double from, double to)
{
    return std::max(0.0, std::min(high, to) - std::max(low, from)) / (high - low);
}

} // namespace

// A box without a bottom stands on a square of 400, 6,400 and 40,000 patches, on a floor of one surface or of four.
// 8 x 8 sample points know the covered length of an edge to a sixteenth.
TEST_CASE("covered parts are found among few patches and many, at the border of surfaces too")
{
    for (const double size : {0.05, 0.0125, 0.005})
        for (const bool in_four : {false, true}) {
            SceneBuilder builder;
            const std::uint32_t paint = builder.grey(0.5, 1.0);
            if (in_four)
                for (const double x : {0.0, 0.5})
                    for (const double z : {0.0, 0.5})
                        builder.rectangle({x, 0, z}, {0, 0, 0.5}, {0.5, 0, 0}, paint);
            else
                builder.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, paint);
            const double left = 0.3021, right = 0.7036, back = 0.2013, front = 0.6027;
            builder.rectangle({left, 0.5, back}, {0, 0, front - back}, {right - left, 0, 0}, paint);
            builder.rectangle({left, 0, back}, {0, 0, front - back}, {0, 0.5, 0}, paint);
            builder.rectangle({right, 0, back}, {0, 0.5, 0}, {0, 0, front - back}, paint);
            builder.rectangle({left, 0, back}, {0, 0.5, 0}, {right - left, 0, 0}, paint);
            builder.rectangle({left, 0, front}, {right - left, 0, 0}, {0, 0.5, 0}, paint);
            const Scene scene = builder.scene(size);
            const std::vector<Rgb> values(scene.patch_count(), Rgb{1.0, 1.0, 1.0});
            const VisiblePatches patches(scene, values, 2);
            double worst = 0.0;
            double covered = 0.0;
            for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
                const Surface shape = scene.patch(i).shape;
                if (shape.origin.y > 0.0 || shape.normal().y < 0.5)
                    continue; // the box
                const Bounds box = shape.bounds();
                const double along_x = share_inside(box.low.x, box.high.x, left, right);
                const double along_z = share_inside(box.low.z, box.high.z, back, front);
                const double exact = 1.0 - along_x * along_z;
                worst = std::max(worst, std::abs(patches.open_share(i) - exact));
                covered += scene.area(i) * (1.0 - patches.open_share(i));
                if (exact == 0.0 || exact == 1.0)
                    CHECK(patches.open_share(i) == exact);
            }
            CAPTURE(size);
            CAPTURE(in_four);
            CHECK(worst <= 0.125);
            CHECK(covered == doctest::Approx((right - left) * (front - back)).epsilon(0.02));
        }
}

} // namespace visible_patches_test
