#include "geometry/intersector/surface_sizes.h"

#include "geometry/intersector/shared_planes.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <vector>

namespace surface_sizes_test {

using namespace multipath;

TEST_CASE("surfaces are ordered by area, equal ones by number, and ranked the other way round")
{
    const auto square = [](double edge) {
        return Surface{Shape::parallelogram, {0, 0, 0}, {edge, 0, 0}, {0, edge, 0}};
    };
    const SurfaceList surfaces = {square(2), square(1), square(3), square(1)};
    CHECK(order_by_descending_area(surfaces) == std::vector<std::uint32_t>{2, 0, 1, 3});
}

TEST_CASE("walls seen from inside form a room, also without one of them, wherever it is; a box in the open does not")
{
    for (const Vec3 low : {Vec3{0, 0, 0}, {5, 5, 5}, {-1e4, 3, -20}, {0.1, -1e5, 1e4}, {-2, -1, 1e5}}) {
        CAPTURE(low.x);
        SceneBuilder inside, outside;
        const Vec3 high = low + Vec3{1, 2, 3};
        const SurfaceList walls = inside.room(low, high, inside.grey(0.5, 1.0)).file().surfaces;
        const SurfaceList faces = outside.box(low, high, outside.grey(0.5, 1.0)).file().surfaces;
        CHECK(is_interior(walls));
        CHECK(!is_interior(faces));
        for (std::size_t missing = 0; missing < walls.size(); ++missing) {
            CAPTURE(missing);
            SurfaceList open = walls;
            open.erase(open.begin() + static_cast<std::ptrdiff_t>(missing));
            CHECK(is_interior(open));
            open = faces;
            open.erase(open.begin() + static_cast<std::ptrdiff_t>(missing));
            CHECK(!is_interior(open));
        }
    }
}

TEST_CASE("boxes leave room on all sides for a shared plane")
{
    SceneBuilder builder;
    const SurfaceList walls = builder.room({0, 0, 0}, {3, 4, 12}, builder.grey(0.5, 1.0)).file().surfaces;
    const double room = 13.0 * coplanar_distance;
    const Bounds box = box_around(walls);
    CHECK(box.low.x < -room);
    CHECK(box.high.z > 12.0 + room);
    const LargeVector<Bounds> boxes = boxes_around_each(walls);
    CHECK(boxes[0].low.y < -room); // the floor
    CHECK(boxes[0].high.y > room);
    CHECK(boxes[0].high.y < 10.0 * room);
}

} // namespace surface_sizes_test
