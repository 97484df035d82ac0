#include "image/shading/smoothing_groups.h"

#include "test_scenes.h"

#include <doctest/doctest.h>

#include <vector>

namespace smoothing_groups_test {

using namespace multipath;

TEST_CASE("what stands between points near each other is found as among all surfaces")
{
    for (const int count : {20, 3000}) { // without and with a tree
        std::uint64_t counter = 0;
        const auto random = [&] { return bits_to_unit(random_bits(7, counter++)); };
        const auto point = [&](double size) { return size * Vec3{random(), random(), random()}; };
        SceneBuilder builder;
        const std::uint32_t paint = builder.grey(0.5, 1.0);
        for (int k = 0; k < count; ++k)
            builder.surface({Shape::triangle, point(1.0), point(0.2), point(-0.2)}, paint);
        const Scene scene = builder.scene(1.0);
        std::vector<Vec3> normals;
        for (const Surface& surface : scene.surfaces())
            normals.push_back(surface.normal());

        int occluded_pairs = 0;
        for (int trial = 0; trial < 100; ++trial) {
            const Vec3 middle = point(1.0);
            std::vector<OpenPoint> points;
            for (int k = 0; k < 4; ++k)
                points.push_back({middle + point(0.05), normalized(point(1.0) + Vec3{0, 3, 0})});
            const NearbyOccluders occluders(scene, normals, points);
            for (const OpenPoint& a : points)
                for (const OpenPoint& b : points) {
                    const bool expected = occluded_between(scene, a, b);
                    REQUIRE(occluders.separate(a, b) == expected);
                    occluded_pairs += expected ? 1 : 0;
                }
        }
        if (count == 3000)
            CHECK(occluded_pairs > 100);
    }
}

} // namespace smoothing_groups_test
