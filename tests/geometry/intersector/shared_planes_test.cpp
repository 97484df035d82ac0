#include "geometry/intersector/shared_planes.h"

#include "geometry/intersector/surface_sizes.h"
#include "geometry/surface_pieces.h"

#include <cmath>
#include <doctest/doctest.h>

namespace shared_planes_test {

using namespace multipath;

namespace {

SharedPlanes planes_of(const SurfaceList& surfaces)
{
    return share_planes(surfaces, order_by_descending_area(surfaces));
}

} // namespace

TEST_CASE("planes further apart than rounding stay apart")
{
    const Surface floor = {Shape::parallelogram, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
    Surface carpet = floor;
    carpet.origin.y = 1e-3;
    Surface dust = floor;
    dust.origin.y = 1e-9;
    CHECK(planes_of({floor, carpet, dust}).plane_number == std::vector<std::uint32_t>{0, 1, 0});
}

// Only faces that look at each other can touch; a mesh that bends a little must not be torn open at its edges.
TEST_CASE("surfaces in one plane get one equation if some of them face the other way, else they keep their own")
{
    const Surface floor = rectangle({0, 0, 0}, {0, 0, 2}, {2, 0, 0});
    const Surface neighbour = rectangle({2, 0, 0}, {0, 0, 1}, {1, 2e-6, 0});
    const Surface bottom = rectangle({0.5, 1e-6, 0.5}, {1, 0, 0}, {0, 0, 1}); // looks down
    const SharedPlanes bent = planes_of({floor, neighbour});
    CHECK(bent.plane_number == std::vector<std::uint32_t>{0, 0});
    CHECK(bent.plane_of_surface[1].normal == neighbour.normal());

    const SharedPlanes touching = planes_of({floor, neighbour, bottom});
    CHECK(touching.plane_number == std::vector<std::uint32_t>{0, 0, 0});
    for (const Plane& plane : touching.plane_of_surface) {
        CHECK(std::abs(plane.normal.y) == 1.0);
        CHECK(plane.offset == 0.0);
    }
    CHECK(dot(touching.plane_of_surface[2].normal, bottom.normal()) > 0.0);
}

} // namespace shared_planes_test
