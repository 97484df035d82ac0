#include "image/clear_sight.h"

#include "geometry/convex_hull.h"
#include "geometry/flat_polygon.h"

#include <algorithm>
#include <utility>

namespace multipath {

namespace {

constexpr std::size_t most_surfaces = 1000; // a search looks at all of them
constexpr std::size_t most_pairs = std::size_t{1} << 24;
constexpr std::uint8_t unclear = 1;
constexpr std::uint8_t clear = 2;

/// Do all points lie on one side of the plane of the surface, or in it?
bool on_one_side(const std::vector<Vec3>& points, const Surface& surface, double touching)
{
    double low = 0.0;
    double high = 0.0;
    for (const Vec3& point : points) {
        const double height = dot(point - surface.origin, surface.normal());
        low = std::min(low, height);
        high = std::max(high, height);
    }
    return low >= -touching || high <= touching;
}

} // namespace

ClearSight::ClearSight(const Scene& scene, std::vector<std::uint32_t> targets)
    : scene_(scene),
      targets_(std::move(targets)),
      touching_(1e-6 * scene.bounds().diagonal()),
      known_(scene.surfaces().size() <= most_surfaces && scene.patch_count() * targets_.size() <= most_pairs
                 ? scene.patch_count() * targets_.size()
                 : 0)
{
}

bool ClearSight::is_clear(std::uint32_t patch, std::size_t target) const
{
    if (patch == Scene::no_patch || known_.empty())
        return false;
    // Threads that search at the same time find the same.
    std::atomic<std::uint8_t>& known = known_[patch * targets_.size() + target];
    std::uint8_t state = known.load(std::memory_order_relaxed);
    if (state == 0) {
        state = find(patch, targets_[target]) ? clear : unclear;
        known.store(state, std::memory_order_relaxed);
    }
    return state == clear;
}

bool ClearSight::find(std::uint32_t patch, std::uint32_t target) const
{
    const Surface here = scene_.patch(patch).shape;
    const Surface& there = scene_.surfaces()[target];
    std::vector<Vec3> points = corners_of(here);
    for (const Vec3& corner : corners_of(there))
        points.push_back(corner);
    const ConvexHull hull(points);
    const std::uint32_t own = scene_.surface_of(patch);
    for (std::uint32_t s = 0; s < scene_.surfaces().size(); ++s) {
        if (s == own || s == target)
            continue;
        const Surface& surface = scene_.surfaces()[s];
        const HeightRange level = heights(polygon_of(surface), here.origin, here.normal());
        // What lies flat on the patch, as the bottom of a box does, darkens it.
        const bool is_flat = level.within(touching_);
        if (!is_flat && on_one_side(points, surface, touching_))
            continue;
        if (!hull.is_beside(corners_of(surface), is_flat ? -touching_ : touching_))
            return false;
    }
    return true;
}

} // namespace multipath
