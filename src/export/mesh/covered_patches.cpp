// The surfaces that lie over a patch are subtracted from the patch until an uncovered point is found or nothing is
// left. The rest of the patch is kept as a list of triangles. The next surface to subtract is one that covers the
// centroid of the first triangle. If no surface covers that centroid, the patch is visible there.

#include "export/mesh/covered_patches.h"

#include "geometry/intersector/intersector.h"
#include "geometry/polygon.h"
#include "parallel/blocks.h"

#include <algorithm>
#include <cstdint>

namespace multipath {

namespace {

constexpr double least_share = 2e-4; ///< share of the patch; smaller triangles result from rounded coordinates in files

double area_of(const FlatPolygon& triangle)
{
    return 0.5 * length(cross(triangle.corners[1] - triangle.corners[0], triangle.corners[2] - triangle.corners[0]));
}

/// Appends the polygon as a fan of triangles, without those of at most `least_area`.
void append_triangles(const FlatPolygon& polygon, double least_area, std::vector<FlatPolygon>& triangles)
{
    for (std::size_t k = 1; k + 1 < polygon.size; ++k) {
        FlatPolygon triangle;
        for (const std::size_t corner : {std::size_t{0}, k, k + 1})
            triangle.add(polygon.corners[corner]);
        if (area_of(triangle) > least_area)
            triangles.push_back(triangle);
    }
}

/// The parts of triangles outside a convex surface in the same plane.
std::vector<FlatPolygon> without(const std::vector<FlatPolygon>& triangles, const Surface& surface, double least_area)
{
    const FlatPolygon cover = polygon_of(surface);
    std::vector<FlatPolygon> outside;
    std::vector<FlatPolygon> inside = triangles;
    for (std::size_t k = 0; k < cover.size; ++k) {
        const Vec3 inward = normalized(cross(surface.normal(), cover.next(k) - cover.corners[k]));
        std::vector<FlatPolygon> still_inside;
        for (const FlatPolygon& triangle : inside) {
            append_triangles(part_in_front(triangle, cover.corners[k], -inward, 0.0), least_area, outside);
            append_triangles(part_in_front(triangle, cover.corners[k], inward, 0.0), least_area, still_inside);
        }
        inside = std::move(still_inside);
    }
    return outside;
}

/// True if `surface` hides the given side of a coplanar patch where they overlap: a ray that arrives at that side meets
/// a visible side of `surface` first.
bool lies_over(const Scene& scene, std::uint32_t surface, const Patch& patch, bool front)
{
    const bool faces_viewer = dot(scene.surfaces()[surface].normal(), patch.shape.normal()) > 0.0;
    if (faces_viewer != front)
        return faces_viewer;
    return (faces_viewer || scene.two_sided()) && scene.intersector().is_over(surface, patch.surface);
}

bool is_covered(const Scene& scene, std::uint32_t number)
{
    const Patch patch = scene.patch(number);
    const bool front = scene.is_front(number);
    const double least_area = least_share * patch.shape.area();
    std::vector<FlatPolygon> left;
    append_triangles(polygon_of(patch.shape), least_area, left);
    std::vector<std::uint32_t> subtracted;
    while (!left.empty()) {
        const FlatPolygon& first = left.front();
        const Vec3 middle = (1.0 / 3.0) * (first.corners[0] + first.corners[1] + first.corners[2]);
        const std::vector<std::uint32_t> there = scene.intersector().coincident_surfaces(patch.surface, middle);
        const auto over = std::find_if(there.begin(), there.end(), [&](std::uint32_t surface) {
            return lies_over(scene, surface, patch, front) &&
                   std::find(subtracted.begin(), subtracted.end(), surface) == subtracted.end();
        });
        if (over == there.end())
            return false;
        left = without(left, scene.surfaces()[*over], least_area);
        subtracted.push_back(*over);
    }
    return true;
}

} // namespace

std::vector<bool> covered_patches(const Scene& scene, int threads)
{
    constexpr std::uint32_t patches_at_a_time = 1024;
    std::vector<std::uint8_t> covered(scene.patch_count());
    parallel_ranges(scene.patch_count(), patches_at_a_time, threads, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t i = first; i < end; ++i)
            covered[i] = is_covered(scene, i) ? 1 : 0;
    });
    return {covered.begin(), covered.end()};
}

} // namespace multipath
